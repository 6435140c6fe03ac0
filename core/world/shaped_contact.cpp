#include "core/world/shaped_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

// Where the two of a pair are, now or later.
struct Placing {
  Vec2 body{0, 0},
      other{0, 0};  // centre of the shaped body; of the disk, or a point of the wall [d]
  double angle = 0;
};

// The row of the shaped body, its first or only corner of the pair, and what it meets.
struct Parties {
  int body = 0, other = 0;
  std::size_t corner = 0;
  bool on_wall = false;
};

Parties parties_of(const World& world, Pair pair) {
  const bool on_wall = is_wall(pair.b);
  const int id = on_wall ? pair.a : pair.b;
  return {.body = world.row(id),
          .other = on_wall ? pair.b : pair.a,
          .corner = static_cast<std::size_t>(id - kCornerBase),
          .on_wall = on_wall};
}

Placing placing_of(const World& world, const Parties& p) {
  return {.body = world.disks.position[p.body],
          .other = p.on_wall ? world.wall(p.other).point : world.disks.position[p.other],
          .angle = world.disks.angle[p.body]};
}

Vec2 turned(const Vec2& v, double cosine, double sine) {
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

ShapedContact contact_at(const World& world, const Parties& p, const Placing& placing) {
  const Corner& first = world.shapes.corners[p.corner];
  const double cosine = std::cos(placing.angle), sine = std::sin(placing.angle);
  ShapedContact contact{.radius = first.radius};
  if (p.on_wall) {
    const Vec2& inward = world.wall(p.other).normal;
    contact.arm = turned(first.place, cosine, sine);
    contact.normal = -inward;
    contact.gap = inward.dot(placing.body + contact.arm - placing.other) - first.radius;
    return contact;
  }
  Vec2 s = placing.body - placing.other;
  s.x() -= world.box.image_shift(s.x());
  constexpr std::size_t kFew = 8;
  Vec2 few[kFew];
  std::vector<Vec2> many;
  const auto count = static_cast<std::size_t>(first.count);
  if (count > kFew) many.resize(count);
  Vec2* const corners = count > kFew ? many.data() : few;
  for (std::size_t k = 0; k < count; ++k)
    corners[k] = s + turned(world.shapes.corners[p.corner + k].place, cosine, sine);
  const NearestPoint nearest = nearest_to_origin({corners, count});
  contact.arm = nearest.foot - s;
  contact.normal = nearest.normal;
  contact.gap = nearest.distance - world.disks.radius[p.other] - first.radius;
  contact.flank = nearest.flank;
  return contact;
}

Placing moved(const World& world, const Parties& p, Placing placing,
              const std::vector<Vec3>& velocity, double dt) {
  placing.body += dt * velocity[p.body].head<2>();
  placing.angle += dt * velocity[p.body].z();
  placing.other += dt * velocity[world.velocity_row(p.other)].head<2>();
  return placing;
}

}  // namespace

ShapedContact shaped_contact(const World& world, Pair pair) {
  const Parties p = parties_of(world, pair);
  return contact_at(world, p, placing_of(world, p));
}

ShapedContact shaped_contact_after(const World& world, Pair pair, const std::vector<Vec3>& velocity,
                                   double dt) {
  const Parties p = parties_of(world, pair);
  return contact_at(world, p, moved(world, p, placing_of(world, p), velocity, dt));
}

double closing_speed(const World& world, Pair pair, const std::vector<Vec3>& velocity) {
  const Parties p = parties_of(world, pair);
  const ShapedContact contact = contact_at(world, p, placing_of(world, p));
  const Vec3 &of_body = velocity[p.body], &of_other = velocity[world.velocity_row(p.other)];
  const Vec2 u = of_body.head<2>() - of_other.head<2>() + of_body.z() * perpendicular(contact.arm);
  // Farther from the foot the body's points are faster.
  const bool turns = world.shapes.corners[p.corner].count > 1;
  return u.norm() + (turns ? std::abs(of_body.z()) * std::max(0.0, contact.gap) : 0);
}

double shaped_turning_rate(const World& world, Pair pair, const std::vector<Vec3>& velocity) {
  const Parties p = parties_of(world, pair);
  const ShapedContact contact = contact_at(world, p, placing_of(world, p));
  const Vec3& of_body = velocity[p.body];
  const double spin = of_body.z();
  if (p.on_wall) return spin * spin * contact.normal.dot(contact.arm);
  const Vec2 u = of_body.head<2>() - velocity[p.other].head<2>();
  if (!contact.flank) {
    // The corner is the centre of a disk that turns about the centre of mass.
    const double u_ct = perpendicular(contact.normal).dot(u + spin * perpendicular(contact.arm));
    return u_ct * u_ct / (contact.radius + world.disks.radius[p.other] + contact.gap) -
           spin * spin * contact.normal.dot(contact.arm);
  }
  // Seen from the body, where the flank is straight and does not move, the disk is at -s and accelerates by
  // 2 spin x u + spin^2 s, Coriolis and centrifugal together; the gap opens along -n.
  const double to_disk = world.disks.radius[p.other] + contact.radius + contact.gap;
  const Vec2 s = to_disk * contact.normal - contact.arm;  // from the disk to the centre of mass
  return -contact.normal.dot(2 * spin * perpendicular(u) + spin * spin * s);
}

bool meets_within(const World& world, Pair pair, const std::vector<Vec3>& velocity, double dt,
                  double tolerance) {
  const Parties p = parties_of(world, pair);
  const Placing start = placing_of(world, p);
  const double arm = world.shapes.find(p.body)->arm;
  const double path =
      dt * ((velocity[p.body] - velocity[world.velocity_row(p.other)]).head<2>().norm() +
            std::abs(velocity[p.body].z()) * arm);
  // So short that the disk cannot be in front of the part at one look and behind it at the next.
  const double thickness =
      world.shapes.corners[p.corner].radius + (p.on_wall ? 0 : world.disks.radius[p.other]);
  const int looks = std::max(1, static_cast<int>(std::min(std::ceil(2 * path / thickness), 1e4)));
  for (int k = 1; k <= looks; ++k) {
    const Placing then = moved(world, p, start, velocity, dt * k / looks);
    if (contact_at(world, p, then).gap < -tolerance) return true;
  }
  return false;
}

int add_shape(World& world, const Disk& disk, std::span<const ConvexPart> parts) {
  MassProperties whole = mass_properties(parts);
  Disk equal = disk;
  equal.role = DiskRole::intruder;
  equal.radius = std::sqrt(whole.area / std::numbers::pi);
  const bool one_disk = parts.size() == 1 && parts.front().corners.size() == 1;
  if (one_disk) {
    equal.radius = parts.front().radius;
    whole.centre = parts.front().corners.front();
  }
  const int body = world.disks.add(equal);
  const double mass = world.disks.mass[body];
  ShapedBody shaped{
      .body = body,
      .inertia = one_disk ? world.disks.inertia(body) : mass * whole.second_moment / whole.area};
  if (!disk.fixed) world.disks.inverse_mass[body] = Vec3(1 / mass, 1 / mass, 1 / shaped.inertia);
  for (const ConvexPart& part : parts)
    for (const Vec2& corner : part.corners) {
      const Vec2 place = corner - whole.centre;
      world.shapes.corners.push_back({.place = place,
                                      .radius = part.radius,
                                      .body = body,
                                      .count = static_cast<int>(part.corners.size()),
                                      .shaft = part.shaft});
      shaped.arm = std::max(shaped.arm, place.norm());
      shaped.radius = std::max(shaped.radius, part.radius);
    }
  world.shapes.bodies.push_back(shaped);
  return body;
}

void add_shaped_pairs(const World& world, double distance, std::vector<Pair>& pairs) {
  const int nc = static_cast<int>(world.shapes.corners.size());
  const auto offer = [&](Pair pair) {
    if (world.gap(pair) <= distance) pairs.push_back(pair);
  };
  for (const ShapedBody& shaped : world.shapes.bodies)
    for (int i = 0; i < world.disks.size(); ++i) {
      if (world.shapes.find(i)) continue;  // shaped bodies do not touch each other
      const double apart = world.separation(i, shaped.body).norm();
      if (apart > shaped.reach() + world.disks.radius[i] + distance) continue;
      world.shapes.for_each_part([&](std::span<const Corner> part, std::size_t first) {
        if (part.front().body == shaped.body) offer({i, kCornerBase + static_cast<int>(first)});
      });
    }
  for (int k = 0; k < nc; ++k)
    for (int w = 0; w < static_cast<int>(world.walls.size()); ++w)
      offer({kCornerBase + k, kWallBase + w});
}

namespace {

double extent_at(const World& world, int body, double angle, const Vec2& direction) {
  if (!world.shapes.find(body)) return world.disks.radius[body];
  const double cosine = std::cos(angle), sine = std::sin(angle);
  double most = 0;
  for (const Corner& corner : world.shapes.corners)
    if (corner.body == body)
      most = std::max(most, turned(corner.place, cosine, sine).dot(direction) + corner.radius);
  return most;
}

}  // namespace

double extent(const World& world, int body, const Vec2& direction) {
  return extent_at(world, body, world.disks.angle[body], direction);
}

double extent_as_placed(const World& world, int body, const Vec2& direction) {
  return extent_at(world, body, 0, direction);
}

double lowest_point(const World& world, int body) {
  return world.disks.position[body].y() - extent(world, body, {0, -1});
}

double highest_point_of(const World& world, int body) {
  return world.disks.position[body].y() + extent(world, body, {0, 1});
}

double half_width(const World& world, int body) {
  return std::max(extent_as_placed(world, body, {1, 0}), extent_as_placed(world, body, {-1, 0}));
}

double reach_of(const World& world, int body) {
  const ShapedBody* shaped = world.shapes.find(body);
  return shaped ? shaped->reach() : world.disks.radius[body];
}

double fastest_point(const World& world, int body) {
  const Vec3& v = world.disks.velocity[body];
  return v.head<2>().norm() + reach_of(world, body) * std::abs(v.z());
}

double speed_of_body(const World& world, int body) {
  return world.shapes.find(body) ? fastest_point(world, body)
                                 : world.disks.velocity[body].head<2>().norm();
}

std::vector<ConvexPart> parts_in_place(const World& world, int body) {
  const Vec2& centre = world.disks.position[body];
  const double cosine = std::cos(world.disks.angle[body]), sine = std::sin(world.disks.angle[body]);
  std::vector<ConvexPart> parts;
  world.shapes.for_each_part([&](std::span<const Corner> corners, std::size_t) {
    const Corner& first = corners.front();
    if (first.body != body) return;
    ConvexPart& part =
        parts.emplace_back(ConvexPart{.corners = {}, .radius = first.radius, .shaft = first.shaft});
    for (const Corner& corner : corners)
      part.corners.emplace_back(centre + turned(corner.place, cosine, sine));
  });
  return parts;
}

bool holds(const World& world, int body, const Vec2& place) {
  Vec2 away = place - world.disks.position[body];
  away.x() -= world.box.image_shift(away.x());
  if (away.norm() > reach_of(world, body)) return false;
  if (!world.shapes.find(body)) return true;
  const double cosine = std::cos(world.disks.angle[body]), sine = std::sin(world.disks.angle[body]);
  std::vector<Vec2> corners;
  for (std::size_t k = 0; k < world.shapes.corners.size(); k += corners.size()) {
    const Corner& first = world.shapes.corners[k];
    corners.clear();
    for (std::size_t i = 0; i < static_cast<std::size_t>(first.count); ++i)
      corners.emplace_back(turned(world.shapes.corners[k + i].place, cosine, sine) - away);
    if (first.body == body && nearest_to_origin(corners).distance <= first.radius) return true;
  }
  return false;
}

}  // namespace quicksand
