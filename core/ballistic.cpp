#include "core/ballistic.h"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

bool is_floor(const Wall& wall) { return wall.normal.y() > 0.5; }

// Where the disk is when it first comes within `capture` of a body, and of which.
std::optional<Landing> first_met(const World& world, double x, double radius, double capture) {
  std::optional<Landing> highest;
  const auto offer = [&](double y, int body) {
    if (!highest || y > highest->centre.y()) highest = Landing{.centre = {x, y}, .touched = body};
  };
  for (std::size_t k = 0; k < world.walls.size(); ++k) {
    const Wall& wall = world.walls[k];
    if (!is_floor(wall)) continue;
    const double along = wall.normal.x() * (x - wall.point.x());
    offer(wall.point.y() + (radius + capture - along) / wall.normal.y(),
          kWallBase + static_cast<int>(k));
  }
  const double width = world.box.sides == Sides::periodic ? world.box.width : 0;
  for (int i = 0; i < world.disks.size(); ++i) {
    double dx = x - world.disks.position[i].x();
    if (width > 0) dx -= width * std::nearbyint(dx / width);
    const double reach = radius + world.disks.radius[i] + capture;
    if (std::abs(dx) < reach)
      offer(world.disks.position[i].y() + std::sqrt(reach * reach - dx * dx), i);
  }
  return highest;
}

// The captured disk after it was drawn to what captured it.
Vec2 drawn_in(const World& world, const Landing& met, double radius, double capture) {
  if (is_wall(met.touched)) return met.centre - capture * world.wall(met.touched).normal;
  Vec2 apart = met.centre - world.disks.position[met.touched];
  if (world.box.sides == Sides::periodic)
    apart.x() -= world.box.width * std::nearbyint(apart.x() / world.box.width);
  const double touching = radius + world.disks.radius[met.touched];
  return met.centre - capture / (touching + capture) * apart;
}

bool in_a_side_wall(const World& world, const Vec2& centre, double radius) {
  return std::ranges::any_of(world.walls, [&](const Wall& wall) {
    return !is_floor(wall) && wall.normal.dot(centre - wall.point) < radius;
  });
}

}  // namespace

std::optional<Landing> land(const World& world, double x, double radius, double capture) {
  std::optional<Landing> landing = first_met(world, x, radius, capture);
  if (!landing || capture == 0) return landing;
  landing->centre = drawn_in(world, *landing, radius, capture);
  if (in_a_side_wall(world, landing->centre, radius)) return first_met(world, x, radius, 0);
  return landing;
}

}  // namespace quicksand
