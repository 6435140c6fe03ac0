#include "core/bodies/drag.h"

namespace quicksand {

void apply_drag(const Drag& drag, const Disks& disks, double dt, std::vector<Vec3>& of_body) {
  for (int i = 0; i < disks.size(); ++i) {
    if (disks.fixed(i)) continue;
    const double diameter = 2 * disks.radius[i];
    const double speed = disks.velocity[i].head<2>().norm();
    const double resistance = diameter * (drag.linear + drag.quadratic * diameter * speed);
    of_body[i].head<2>() *= disks.mass[i] / (disks.mass[i] + dt * resistance);
  }
}

}  // namespace quicksand
