#include "tests/support/core/random_heaps.h"

#include <algorithm>
#include <cmath>

#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/step/assemble.h"
#include "core/world/ballistic.h"
#include "core/world/neighbors.h"

namespace quicksand {

World random_heap(const HeapShape& shape, Random& random) {
  const auto between = [&](double a, double b) { return a + (b - a) * random.uniform(); };
  const auto mass = [&] { return std::pow(shape.mass_ratio, random.uniform()); };
  const auto law = [&] {
    ContactLaw drawn;
    if (shape.components >= 2) drawn.friction = between(0, shape.largest_friction);
    if (shape.components >= 3) drawn.rolling_friction = between(0, 0.5);
    if (shape.bonded > 0) drawn.cohesion_force = 20;
    return drawn;
  };
  Scenario scene;
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 3, .height = 20, .sides = Sides::walls, .floor = true};
  scene.grain_law = law();
  scene.wall_law = law();
  World world = make_world(scene);
  double top = 0;
  for (int k = 0; k < shape.disks; ++k) {
    const double radius = between(0.3, 1);
    const Vec2 place = LandingSite(world).land(between(radius, 3 - radius), radius)->centre;
    top = std::max(top, place.y() + radius);
    world.disks.add({.position = place,
                     .radius = radius,
                     .density = mass() / (4 * radius * radius),
                     .velocity = {between(-1, 1), between(-1, 1)},
                     .spin = between(-1, 1)});
  }
  if (shape.piston)
    world.walls.push_back({.point = {0, top},
                           .normal = {0, -1},
                           .velocity = {0, between(-1, 0)},
                           .mass = mass(),
                           .force = between(0, 10),
                           .role = WallRole::piston});
  std::vector<Pair> bonds;
  for (const Pair& pair : pairs_within(world, 1e-9))
    if (random.uniform() < shape.bonded) bonds.push_back(pair);
  world.bonds.form(bonds);
  return world;
}

ContactProblem next_problem(const World& world, const StepSettings& step) {
  std::vector<Vec3> velocity;
  std::vector<Contact> contacts;
  ContactProblem problem;
  free_velocities(world, step.dt, velocity);
  find_contacts(world, pairs_within(world, 0.1), velocity, step.dt, contacts);
  build_problem(world, contacts, velocity, step, problem);
  return problem;
}

}  // namespace quicksand
