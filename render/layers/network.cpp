#include "render/layers/network.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/world/shaped_contact.h"
#include "render/base/nice_numbers.h"
#include "render/base/palette.h"

namespace quicksand {
namespace {

constexpr double kThinnestForce = 0.35;  // [px]; weaker forces are left out
constexpr double kWidestForce = 1.2;     // [d]
constexpr double kBarLength = 0.62;      // over the smaller diameter [1]

// Calls draw(from, to) in pixels for each visible image of the link.
template <typename Draw>
void at_each_image(const World& world, const Panel& panel, const PairLine& link, Draw draw) {
  const double x = link.from.x();
  at_each_image(world.box, std::min(x, x + link.along.x()), std::max(x, x + link.along.x()),
                [&](double shift) {
                  const Vec2 from = panel.camera.to_pixel(link.from + Vec2(shift, 0));
                  const Vec2 to = panel.camera.to_pixel(link.from + link.along + Vec2(shift, 0));
                  const double reach = (to - from).norm() / 2 + panel.camera.scale();
                  if (panel.sees((from + to) / 2, reach)) draw(from, to);
                });
}

}  // namespace

PairLine link_of(const World& world, Pair pair) {
  if (is_shaped(pair)) {
    const ShapedContact at = shaped_contact(world, pair);
    const auto from = static_cast<std::size_t>(world.row(pair.a));
    const Vec2 middle(world.wrapped_x(world.disks.position[from].x()),
                      world.disks.position[from].y());
    if (is_wall(pair.b)) return {middle, at.arm + (at.radius + at.gap) * at.normal};
    return {middle, (world.disks.radius[from] + at.gap) * at.normal};
  }
  const auto a = static_cast<std::size_t>(pair.a);
  const Vec2 centre(world.wrapped_x(world.disks.position[a].x()), world.disks.position[a].y());
  if (!is_wall(pair.b)) return {centre, world.separation(pair.a, pair.b)};
  Vec2 normal;
  const double gap = world.gap(pair, &normal);
  return {centre, (world.disks.radius[a] + gap) * normal};
}

double bond_width(double pixels_per_diameter) {
  return std::clamp(0.14 * pixels_per_diameter, 0.7, 5.0);
}

Colour bond_colour(const View& view) {
  const Palette& colours = palette(view.theme);
  return view.forces ? colours.faint_ink : colours.ink;
}

double bar_width(double pixels_per_diameter) { return std::min(0.2 * pixels_per_diameter, 8.0); }

// Below this are rounding, and what solvers leave at their usual tolerance. [F_g]
double least_force(const World& world) {
  constexpr double kTolerance = 1e-6;
  return kTolerance * std::max(world.grain_law.cohesion_force.value_or(0),
                               world.gravity ? world.gravity->norm() : 0.0);
}

double usual_force(const World& world) {
  const double least = least_force(world);
  std::vector<double> forces;
  if (world.impulse_dt > 0) {
    for (const Contact& contact : world.contacts) {
      const double force = std::abs(contact.normal_force(world.impulse_dt));
      if (force > least && std::isfinite(force)) forces.push_back(force);
    }
  }
  if (forces.empty()) return 0;
  const auto high = forces.begin() + static_cast<std::ptrdiff_t>((forces.size() - 1) * 99 / 100);
  std::nth_element(forces.begin(), high, forces.end());
  return nice_above(*high);
}

double force_scale(const World& world, const View& view) {
  if (view.force_scale > 0) return view.force_scale;
  const double usual = usual_force(world);
  return usual > 0 ? usual : 1;
}

void draw_bonds(DrawList& list, const World& world, const View& view, const Panel& panel) {
  const double width = bond_width(panel.camera.scale());
  const Colour colour = bond_colour(view);
  for (const Bond& bond : world.bonds.list) {
    if (bond.state != BondState::active) continue;
    at_each_image(world, panel, link_of(world, bond.pair), [&](const Vec2& from, const Vec2& to) {
      list.line(from, to, width, colour, true);
    });
  }
}

void draw_forces(DrawList& list, const World& world, const View& view, const Panel& panel,
                 double scale_force) {
  if (!(world.impulse_dt > 0)) return;
  const Palette& colours = palette(view.theme);
  const double pixels_per_force = kReferenceWidth * panel.camera.scale() / scale_force;
  // Tension above compression: it is rarer.
  for (const bool tensile : {false, true}) {
    for (const Contact& contact : world.contacts) {
      const double force = contact.normal_force(world.impulse_dt);
      const double width =
          std::min(std::abs(force) * pixels_per_force, kWidestForce * panel.camera.scale());
      if ((force < 0) != tensile || !(width >= kThinnestForce)) continue;
      at_each_image(
          world, panel, link_of(world, contact.pair), [&](const Vec2& from, const Vec2& to) {
            list.line(from, to, width, tensile ? colours.tensile : colours.compressive, true);
          });
    }
  }
}

void draw_broken_bonds(DrawList& list, const World& world, const View& view, const Panel& panel) {
  if (panel.camera.scale() < kLeastScaleOfBars) return;
  const double width = bar_width(panel.camera.scale());
  const Palette& colours = palette(view.theme);
  for (const Bond& bond : world.bonds.list) {
    if (bond.state != BondState::broken) continue;
    Vec2 normal;
    const double gap = world.gap(bond.pair, &normal);
    if (!(gap < kStillClose)) continue;
    const auto [a, b] = world.rows(bond.pair);
    const double radius_a = world.disks.radius[static_cast<std::size_t>(a)];
    const double smaller =
        is_wall(b) ? radius_a : std::min(radius_a, world.disks.radius[static_cast<std::size_t>(b)]);
    // The middle of the gap, and half a bar to either side of it.
    PairLine bar = link_of(world, bond.pair);
    if (is_shaped(bond.pair))
      bar.from += bar.along - gap / 2 * normal;
    else
      bar.from += (radius_a + gap / 2) * normal;
    bar.from -= kBarLength * smaller * perpendicular(normal);
    bar.along = 2 * kBarLength * smaller * perpendicular(normal);
    at_each_image(world, panel, bar, [&](const Vec2& from, const Vec2& to) {
      // A rim of the background sets the bars off from any colour of grains.
      list.line(from, to, 1.6 * width, with_alpha(colours.background, 0.85), true);
      list.line(from, to, width, colours.broken, true);
    });
  }
}

}  // namespace quicksand
