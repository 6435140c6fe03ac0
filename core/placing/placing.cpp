#include "core/placing/placing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/errors.h"
#include "core/world/extent.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

Vec2 place_on_surface(const World& world, double x, std::span<const ConvexPart> parts) {
  constexpr double kTouching = 1e-10;  // [d]
  constexpr int kMostLooks = 1000;
  World trial = world;
  const int body = add_shape(trial, {.position = {x, 0}, .fixed = true}, parts);
  const double reach = trial.shapes.find(body)->reach();
  Vec2& place = trial.disks.position[body];
  place.y() = highest_point(world) + reach;
  std::vector<Pair> pairs;
  add_shaped_pairs(trial, std::numeric_limits<double>::infinity(), pairs);
  std::erase_if(pairs, [&](Pair pair) {
    if (is_wall(pair.b)) return !is_floor(trial.wall(pair.b));
    return std::abs(trial.separation(pair.a, body).x()) > reach + trial.disks.radius[pair.a];
  });
  if (pairs.empty()) return place;
  // Above all disks it may still be in a floor, which has no highest point.
  for (const Wall& wall : trial.walls) {
    if (!is_floor(wall)) continue;
    const double along = wall.normal.x() * (x - wall.point.x());
    place.y() = std::max(place.y(), wall.point.y() + (reach - along) / wall.normal.y());
  }
  for (int k = 0; k < kMostLooks; ++k) {
    // Convex bodies that a line separates touch only when the one has fallen to the line of the other: each pair lets it
    // fall at least by its gap over the slope of the normal, and any way where the normal points down.
    double fall = std::numeric_limits<double>::infinity();
    for (const Pair& pair : pairs) {
      Vec2 normal;
      const double gap = trial.gap(pair, &normal);
      const double closing = is_wall(pair.b) ? trial.wall(pair.b).normal.y() : normal.y();
      if (closing > 0) fall = std::min(fall, gap / closing);
    }
    if (fall <= kTouching || std::isinf(fall)) return place;
    place.y() -= fall;
  }
  throw InputError("the intruder", "finds no place on the surface at x = " + message_number(x));
}

}  // namespace quicksand
