#include "app/session/disk_at.h"

namespace quicksand {

int disk_at(const World& world, const Vec2& place) {
  for (int i = 0; i < world.disks.size(); ++i) {
    Vec2 away = place - world.disks.position[i];
    away.x() -= world.box.image_shift(away.x());
    if (away.norm() <= world.disks.radius[i]) return i;
  }
  return -1;
}

}  // namespace quicksand
