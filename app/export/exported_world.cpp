// What is derived from a world before it is exported.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "app/export/tables.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

std::vector<Link> links_of(const World& world, const std::vector<Pair>& touching) {
  std::vector<Pair> pairs = touching;
  for (const Bond& bond : world.bonds.list)
    if (bond.state == BondState::active) pairs.push_back(bond.pair);
  for (const Contact& contact : world.contacts)
    if (contact.cohesion != 0 || !contact.impulse.isZero(0)) pairs.push_back(contact.pair);
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  std::vector<Link> links;
  links.reserve(pairs.size());
  for (const Pair pair : pairs) {
    const auto contact = std::ranges::lower_bound(world.contacts, pair, {}, &Contact::pair);
    const bool listed =
        world.impulse_dt > 0 && contact != world.contacts.end() && contact->pair == pair;
    links.push_back({.pair = pair,
                     .contact = listed ? &*contact : nullptr,
                     .bond = world.bonds.find(pair),
                     .touching = std::ranges::binary_search(touching, pair)});
  }
  return links;
}

// Where a disk is shown: inside periodic sides.
Vec2 shown_at(const World& world, int disk) {
  const Vec2& centre = world.disks.position[disk];
  return {world.wrapped_x(centre.x()), centre.y()};
}

Rectangle covered_by(const World& world) {
  Rectangle covered{.high = {world.box.width, world.box.height}};
  for (int i = 0; i < world.disks.size(); ++i) {
    const Vec2 reach = Vec2::Constant(reach_of(world, i));
    covered.low = covered.low.cwiseMin(shown_at(world, i) - reach);
    covered.high = covered.high.cwiseMax(shown_at(world, i) + reach);
  }
  if (world.box.sides == Sides::periodic) {
    covered.low.x() = 0;
    covered.high.x() = world.box.width;
  }
  return covered;
}

// Around a part, whose corners are where they are shown: along each flank, and in steps around the corner after it.
void add_outline(std::span<const Vec2> corners, double radius, int body, int part,
                 std::vector<OutlinePiece>& pieces) {
  constexpr double kTurn = 2 * std::numbers::pi, kStep = kTurn / 48;
  const std::size_t n = corners.size();
  const auto outward = [&](std::size_t k) {
    const Vec2 along = corners[(k + 1) % n] - corners[k % n];
    return n == 1 ? 0 : std::atan2(-along.x(), along.y());
  };
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < n; ++k) {
    const double from = outward(k);
    double turn = n == 1 ? kTurn : std::fmod(outward(k + 1) - from + 2 * kTurn, kTurn);
    const Vec2& centre = corners[(k + 1) % n];
    const int steps = std::max(1, static_cast<int>(std::ceil(turn / kStep)));
    if (n > 1) points.emplace_back(corners[k] + radius * Vec2(std::cos(from), std::sin(from)));
    for (int i = 0; i < steps; ++i) {
      const double angle = from + turn * i / steps;
      points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    pieces.push_back({body, part, points[i], points[(i + 1) % points.size()]});
}

std::vector<OutlinePiece> outlines_of(const World& world) {
  std::vector<OutlinePiece> pieces;
  int parts = 0;
  world.shapes.for_each_part([&](std::span<const Corner> part, std::size_t) {
    const auto& [place, radius, body, count, shaft] = part.front();
    const Vec2 centre = shown_at(world, body);
    const Eigen::Rotation2Dd turn(world.disks.angle[body]);
    std::vector<Vec2> corners;
    for (const Corner& corner : part) corners.emplace_back(centre + turn * corner.place);
    add_outline(corners, radius, body, parts++, pieces);
  });
  return pieces;
}

}  // namespace

ExportedWorld::ExportedWorld(const World& exported)
    : world(exported),
      touching(touching_pairs(exported)),
      counts(count_neighbours(exported, touching)),
      pressure(contact_pressure(exported)),
      links(links_of(exported, touching)),
      outlines(outlines_of(exported)),
      covered(covered_by(exported)) {}

Vec2 ExportedWorld::place(int disk) const { return shown_at(world, disk); }

Vec2 ExportedWorld::branch(const Link& link) const {
  if (is_shaped(link.pair)) {
    const ShapedContact at = shaped_contact(world, link.pair);
    if (is_wall(link.pair.b)) return at.arm + (at.radius + at.gap) * at.normal;
    return (world.disks.radius[link.pair.a] + at.gap) * at.normal;
  }
  const auto [a, b] = link.pair;
  if (!is_wall(b)) return world.separation(a, b);
  const Wall& wall = world.wall(b);
  return -wall.normal.dot(world.disks.position[a] - wall.point) * wall.normal;
}

Vec2 ExportedWorld::wall_end(int wall, int which) const {
  const Wall& w = world.walls[static_cast<std::size_t>(wall)];
  const Vec2 along = perpendicular(w.normal);
  const Vec2 middle = (covered.low + covered.high) / 2;
  const Vec2 foot = middle - w.normal.dot(middle - w.point) * w.normal;
  const double half = along.cwiseAbs().dot(covered.high - covered.low) / 2;
  return which == 0 ? Vec2(foot - half * along) : Vec2(foot + half * along);
}

}  // namespace quicksand
