#include "core/placing/placing.h"

#include <algorithm>
#include <limits>

#include "core/world/extent.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

Vec2 place_on_surface(const World& world, double x, std::span<const ConvexPart> parts) {
  constexpr double kTouching = 1e-10;  // [d]
  constexpr int kMostLooks = 10000;
  World trial = world;
  const int body = add_shape(trial, {.position = {x, 0}, .fixed = true}, parts);
  const double reach = trial.shapes.find(body)->reach();
  Vec2& place = trial.disks.position[body];
  place.y() = highest_point(world) + reach;
  // It may fall as far as it is from the nearest without touching anything.
  std::vector<Pair> pairs;
  add_shaped_pairs(trial, std::numeric_limits<double>::infinity(), pairs);
  std::erase_if(pairs, [&](Pair pair) {
    if (is_wall(pair.b)) return !is_floor(trial.wall(pair.b));
    return std::abs(trial.separation(pair.a, body).x()) > reach + trial.disks.radius[pair.a];
  });
  if (pairs.empty()) return place;
  for (int k = 0; k < kMostLooks; ++k) {
    double gap = std::numeric_limits<double>::infinity();
    for (const Pair& pair : pairs) gap = std::min(gap, trial.gap(pair));
    if (gap <= kTouching) break;
    place.y() -= gap;
  }
  return place;
}

}  // namespace quicksand
