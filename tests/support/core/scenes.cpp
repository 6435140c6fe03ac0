#include "tests/support/core/scenes.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/random.h"
#include "core/scene/scenario.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {

Scenario empty_scene(Method method) {
  Scenario scene;
  scene.box = {.width = 0, .height = 0, .sides = Sides::open, .floor = false};
  scene.solver = {.method = method, .tolerance = tolerance::kTight, .max_iterations = 1000000};
  scene.step.stop_if_unconverged = false;  // tests look at such steps themselves
  return scene;
}

ContactLaw paper_law(double cohesion) {
  ContactLaw law{.friction = 0.3, .rolling_friction = 0.1};
  if (cohesion > 0) law.cohesion_force = cohesion;
  return law;
}

Scenario column(Method method, int n, const ContactLaw& law) {
  Scenario scene = empty_scene(method);
  scene.box.floor = true;
  scene.gravity = Vec2(0, -1);
  scene.grain_law = law;
  for (int k = 0; k < n; ++k) scene.disks.push_back({.position = {0, 0.5 + k}});
  return scene;
}

namespace {

// A fixed disk and n bonded ones in a row.
Scenario bonded_row(Method method, int n, const Vec2& direction, double cohesion) {
  Scenario scene = empty_scene(method);
  scene.gravity = Vec2(0, -1);
  scene.grain_law = paper_law(cohesion);
  scene.initial_bonds = InitialBonds::touching;
  for (int k = 0; k <= n; ++k) scene.disks.push_back({.position = k * direction, .fixed = k == 0});
  return scene;
}

}  // namespace

Scenario bonded_row(int n) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = paper_law(10);
  scene.initial_bonds = InitialBonds::touching;
  for (int k = 0; k < n; ++k) scene.disks.push_back({.position = {0.5 + k, 0}});
  return scene;
}

Scenario hanging_chain(Method method, int n, double cohesion) {
  return bonded_row(method, n, {0, -1}, cohesion);
}

Scenario cantilever(Method method, int n, double cohesion) {
  return bonded_row(method, n, {1, 0}, cohesion);
}

Scenario incline(Method method, double slope, const ContactLaw& law) {
  Scenario scene = empty_scene(method);
  scene.gravity = Vec2(0, -1);
  scene.grain_law = law;
  const Vec2 normal = Vec2(slope, 1).normalized();
  scene.walls.push_back({.point = -0.5 * normal, .normal = normal});
  scene.disks.push_back({});
  return scene;
}

Scenario spinning_pair(Method method, double spin, double cohesion) {
  Scenario scene = empty_scene(method);
  scene.grain_law = paper_law(cohesion);
  scene.initial_bonds = InitialBonds::touching;
  scene.disks.push_back({.position = {-0.5, 0}, .velocity = {0, -spin / 2}, .spin = spin});
  scene.disks.push_back({.position = {0.5, 0}, .velocity = {0, spin / 2}, .spin = spin});
  return scene;
}

Scenario pulled_pair(Method method, double force, double cohesion) {
  Scenario scene = empty_scene(method);
  scene.grain_law = paper_law(cohesion);
  scene.initial_bonds = InitialBonds::touching;
  scene.disks = {{.position = {0, 0}, .fixed = true}, {.position = {1, 0}}};
  scene.disk_forces = {{0, 0, 0}, {force, 0, 0}};
  return scene;
}

Scenario falling_cluster(Method method, int n, std::uint64_t seed, const ContactLaw& law) {
  Scenario scene = empty_scene(method);
  scene.box.floor = true;
  scene.gravity = Vec2(0, -1);
  scene.grain_law = law;
  Random random{seed};
  const int columns = static_cast<int>(std::ceil(std::sqrt(n)));
  for (int k = 0; k < n; ++k) {
    const auto jitter = [&] { return 0.15 * (random.uniform() - 0.5); };
    scene.disks.push_back(
        {.position = {1.2 * (k % columns) + jitter(), 0.6 + 1.2 * (k / columns) + jitter()},
         .radius = 0.3 + 0.2 * random.uniform(),
         .velocity = {2 * random.uniform() - 1, -2 * random.uniform()},
         .spin = 4 * random.uniform() - 2});
  }
  return scene;
}

Scenario small_collapse(Method method, std::uint64_t seed) {
  Scenario scene = empty_scene(method);
  scene.seed = seed;
  scene.box = {.width = 10, .height = 20, .sides = Sides::periodic, .floor = true};
  scene.gravity = Vec2(0, -1);
  scene.grain_law = paper_law(100);
  scene.solver.tolerance = 1e-6;
  scene.solver.max_iterations = 300;  // restarts and hashes hold in unconverged steps too
  scene.phases.push_back({DepositPhase{.grains = 25, .interval = 0.02}, 1e-2});
  scene.phases.push_back({SettlePhase{.max_time = 0.3}, 5e-3});
  scene.phases.push_back({PushPhase{.force = 200, .max_time = 0.3}, 2e-3});
  return scene;
}

Scenario rotated(const Scenario& scenario, double angle) {
  Scenario scene = scenario;
  const Eigen::Rotation2Dd turn(angle);
  const auto turn_in_place = [&](Vec2& v) { v = turn * v; };
  if (scene.gravity) turn_in_place(*scene.gravity);
  for (Disk& disk : scene.disks) turn_in_place(disk.position), turn_in_place(disk.velocity);
  for (Vec3& force : scene.disk_forces) force.head<2>() = turn * Vec2(force.head<2>());
  // The floor of a box cannot turn, a wall can.
  if (scene.box.floor) scene.walls.insert(scene.walls.begin(), {.role = WallRole::floor});
  scene.box.floor = false;
  for (Wall& wall : scene.walls)
    turn_in_place(wall.point), turn_in_place(wall.normal), turn_in_place(wall.velocity);
  return scene;
}

Scenario mirrored(const Scenario& scenario) {
  Scenario scene = scenario;
  const auto mirror = [&](Vec2& v) { v.x() = -v.x(); };
  if (scene.gravity) mirror(*scene.gravity);
  for (Disk& disk : scene.disks) {
    mirror(disk.position), mirror(disk.velocity);
    disk.spin = -disk.spin;
  }
  for (Vec3& force : scene.disk_forces) force.x() = -force.x(), force.z() = -force.z();
  for (Wall& wall : scene.walls) mirror(wall.point), mirror(wall.normal), mirror(wall.velocity);
  return scene;
}

}  // namespace quicksand
