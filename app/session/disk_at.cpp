#include "app/session/disk_at.h"

#include "core/world/shaped_contact.h"

namespace quicksand {

int disk_at(const World& world, const Vec2& place) {
  for (int i = 0; i < world.disks.size(); ++i)
    if (holds(world, i, place)) return i;
  return -1;
}

std::string body_name(const World& world, int body) {
  if (!is_wall(body)) return std::to_string(body);
  switch (world.wall(body).role) {
    case WallRole::floor:
      return "floor";
    case WallRole::side:
      return "side";
    case WallRole::piston:
      return "piston";
  }
  return {};
}

}  // namespace quicksand
