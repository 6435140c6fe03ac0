#include "core/world/extent.h"

#include <algorithm>
#include <optional>

namespace quicksand {

double packing_top(const World& world) {
  std::optional<double> top;
  for (int i = 0; i < world.disks.size(); ++i) {
    if (world.disks.role[i] != Role::grain) continue;
    const double of_grain = world.disks.position[i].y() + world.disks.radius[i];
    top = std::max(top.value_or(of_grain), of_grain);
  }
  return top.value_or(0);
}

double weight_above(const World& world, double height) {
  if (!world.gravity) return 0;
  double mass = 0;
  for (int i = 0; i < world.disks.size(); ++i)
    if (world.disks.role[i] == Role::grain && world.disks.position[i].y() > height)
      mass += world.disks.mass[i];
  return mass * world.gravity->norm();
}

}  // namespace quicksand
