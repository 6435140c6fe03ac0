#include "core/forces/wall_loads.h"

namespace quicksand {

namespace {

// What is not named otherwise is a floor where it faces up, a side where it is upright, and a lid like a piston.
WallRole bearing_of(const Wall& wall) {
  if (wall.role != WallRole::floor || wall.normal.y() > 0) return wall.role;
  return wall.normal.y() < 0 ? WallRole::piston : WallRole::side;
}

}  // namespace

WallLoads wall_loads(const World& world) {
  WallLoads loads;
  const auto add = [&](const Wall& wall, const Vec2& force) {
    const auto to = [](std::optional<double>& sum, double part) { sum = sum.value_or(0) + part; };
    const double normal = -force.dot(wall.normal);
    switch (bearing_of(wall)) {
      case WallRole::floor:
        to(loads.floor, -force.y());
        break;
      case WallRole::side:
        to(loads.side, -force.y());
        to(loads.side_thrust, normal);
        break;
      case WallRole::piston:
        to(loads.piston, normal);
        to(loads.piston_shear, -force.x());
        break;
    }
  };
  for (const Wall& wall : world.walls) add(wall, {0, 0});
  if (world.impulse_dt == 0) return loads;
  for (const Contact& contact : world.contacts)
    if (is_wall(contact.pair.b)) add(world.wall(contact.pair.b), contact.force(world.impulse_dt));
  return loads;
}

Vec2 force_on_wall(const World& world, int wall) {
  Vec2 sum(0, 0);
  if (world.impulse_dt == 0) return sum;
  for (const Contact& contact : world.contacts)
    if (contact.pair.b == kWallBase + wall) sum += contact.force(world.impulse_dt);
  return sum;
}

}  // namespace quicksand
