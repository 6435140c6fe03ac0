#include "core/scene/make_world.h"

namespace quicksand {

void take_laws(World& world, const Scenario& scenario) {
  world.gravity = scenario.gravity;
  world.drag = scenario.drag;
  world.grain_law = scenario.grain_law;
  world.wall_law = scenario.wall_law.value_or(scenario.grain_law);
  world.intruder_law = scenario.intruder_law.value_or(scenario.grain_law);
}

World make_world(const Scenario& scenario) {
  World world;
  world.box = scenario.box;
  take_laws(world, scenario);
  world.random.state = scenario.seed;
  if (scenario.box.floor) world.walls.push_back({.role = WallRole::floor});
  if (scenario.box.sides == Sides::walls) {
    world.walls.push_back({.normal = {1, 0}, .role = WallRole::side});
    world.walls.push_back(
        {.point = {scenario.box.width, 0}, .normal = {-1, 0}, .role = WallRole::side});
  }
  world.walls.insert(world.walls.end(), scenario.walls.begin(), scenario.walls.end());
  for (std::size_t i = 0; i < scenario.disks.size(); ++i) {
    const int body = world.disks.add(scenario.disks[i]);
    if (i < scenario.disk_forces.size()) world.disks.applied[body] = scenario.disk_forces[i];
  }
  if (scenario.initial_bonds == InitialBonds::touching) {
    world.bonds.form(bondable_pairs(world));
    world.bonds.mark_initial();
  }
  return world;
}

}  // namespace quicksand
