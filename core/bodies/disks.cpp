#include "core/bodies/disks.h"

#include "core/base/memory.h"

namespace quicksand {

int Disks::add(const Disk& disk) {
  const double m = disk.density * 4 * disk.radius * disk.radius;
  const double i = m * disk.radius * disk.radius / 2;
  append(position, disk.position);
  append(angle, 0.0);
  append(velocity, Vec3(disk.velocity.x(), disk.velocity.y(), disk.spin));
  append(applied, Vec3(0, 0, 0));
  append(radius, disk.radius);
  append(mass, m);
  append(inverse_mass, disk.fixed ? Vec3(0, 0, 0) : Vec3(1 / m, 1 / m, 1 / i));
  append(role, disk.role);
  return size() - 1;
}

}  // namespace quicksand
