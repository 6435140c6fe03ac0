#include "core/ballistic.h"

#include <cmath>

namespace quicksand {

std::optional<Landing> land(const World& world, double x, double radius) {
  std::optional<Landing> highest;
  const auto offer = [&](double y, int body) {
    if (!highest || y > highest->centre.y()) highest = Landing{.centre = {x, y}, .touched = body};
  };
  for (std::size_t k = 0; k < world.walls.size(); ++k) {
    const Wall& wall = world.walls[k];
    if (wall.normal.y() <= 0.5) continue;
    const double along = wall.normal.x() * (x - wall.point.x());
    offer(wall.point.y() + (radius - along) / wall.normal.y(), kWallBase + static_cast<int>(k));
  }
  const double width = world.box.sides == Sides::periodic ? world.box.width : 0;
  for (int i = 0; i < world.disks.size(); ++i) {
    double dx = x - world.disks.position[i].x();
    if (width > 0) dx -= width * std::nearbyint(dx / width);
    const double reach = radius + world.disks.radius[i];
    if (std::abs(dx) < reach)
      offer(world.disks.position[i].y() + std::sqrt(reach * reach - dx * dx), i);
  }
  return highest;
}

}  // namespace quicksand
