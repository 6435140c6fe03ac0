#include "core/drag.h"

#include "core/world.h"

namespace quicksand {

void apply_drag(const World& world, double dt, std::vector<Vec3>& of_body) {
  const Disks& disks = world.disks;
  for (int i = 0; i < disks.size(); ++i) {
    if (disks.fixed(i)) continue;
    const double diameter = 2 * disks.radius[i];
    const double speed = disks.velocity[i].head<2>().norm();
    const double resistance =
        diameter * (world.drag->linear + world.drag->quadratic * diameter * speed);
    of_body[i].head<2>() *= disks.mass[i] / (disks.mass[i] + dt * resistance);
  }
}

}  // namespace quicksand
