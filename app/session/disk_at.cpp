#include "app/session/disk_at.h"

#include <cmath>

namespace quicksand {

int disk_at(const World& world, const Vec2& place) {
  for (int i = 0; i < world.disks.size(); ++i) {
    Vec2 away = place - world.disks.position[i];
    if (world.box.sides == Sides::periodic)
      away.x() -= world.box.width * std::nearbyint(away.x() / world.box.width);
    if (away.norm() <= world.disks.radius[i]) return i;
  }
  return -1;
}

}  // namespace quicksand
