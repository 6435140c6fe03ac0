#include "core/bodies/disks.h"

namespace quicksand {

int Disks::add(const Disk& disk) {
  const double m = disk.density * 4 * disk.radius * disk.radius;
  const double i = m * disk.radius * disk.radius / 2;
  position.push_back(disk.position);
  angle.push_back(0);
  velocity.emplace_back(disk.velocity.x(), disk.velocity.y(), disk.spin);
  applied.emplace_back(0, 0, 0);
  radius.push_back(disk.radius);
  mass.push_back(m);
  inverse_mass.push_back(disk.fixed ? Vec3(0, 0, 0) : Vec3(1 / m, 1 / m, 1 / i));
  role.push_back(disk.role);
  return size() - 1;
}

}  // namespace quicksand
