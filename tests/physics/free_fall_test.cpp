#include "core/problem/solver_settings.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(FreeFall);

Scenario thrown_disk(Method method) {
  Scenario scene = empty_scene(method);
  scene.gravity = Vec2(0, -1);
  scene.disks.push_back({.position = {1, 2}, .velocity = {0.3, 0.7}, .spin = -2});
  return scene;
}

// Implicit Euler has a closed form of its own: v_n = v_0 - n g dt, y_n = y_0 + n dt v_0 - g dt^2
// n (n + 1)/2.
TEST_P(FreeFall, FollowsTheImplicitEulerParabolaExactly) {
  Simulation run(thrown_disk(GetParam()));
  const int n = 500;
  const double dt = run.step.dt, t = n * dt;
  run.advance(n);
  EXPECT_NEAR(run.world.disks.velocity[0].y(), 0.7 - t, tolerance::rounding(10));
  EXPECT_NEAR(run.world.disks.position[0].y(), 2 + 0.7 * t - dt * dt * n * (n + 1) / 2,
              tolerance::rounding(10));
  EXPECT_NEAR(run.world.disks.position[0].x(), 1 + 0.3 * t, tolerance::rounding(10));
  EXPECT_NEAR(run.world.disks.angle[0], -2 * t, tolerance::rounding(10));
}

// Each step takes m g^2 dt^2/2 out of the energy, first order in dt over a fixed time.
TEST_P(FreeFall, LosesTheEnergyOfImplicitEulerAndNoMore) {
  Simulation run(thrown_disk(GetParam()));
  const double before = mechanical_energy(run.world);
  const int n = 500;
  run.advance(n);
  EXPECT_NEAR(mechanical_energy(run.world), before - n * run.step.dt * run.step.dt / 2,
              tolerance::rounding(100));
}

TEST_P(FreeFall, WithoutGravityNothingChanges) {
  Scenario scene = thrown_disk(GetParam());
  scene.gravity.reset();
  Simulation run(scene);
  run.advance(100);
  EXPECT_EQ(distance(run.world.disks.velocity[0], Vec3(0.3, 0.7, -2)), 0);
}

TEST_P(FreeFall, AnAppliedForceAndTorqueAccelerate) {
  Scenario scene = empty_scene(GetParam());
  scene.disks.push_back({.radius = 1, .density = 2});  // mass 8, inertia 4
  scene.disk_forces = {Vec3(4, -2, 3)};
  Simulation run(scene);
  run.run_for(1);
  EXPECT_LE(distance(run.world.disks.velocity[0], Vec3(0.5, -0.25, 0.75)), tolerance::rounding(10));
}

TEST_P(FreeFall, AFixedDiskKeepsItsVelocityWhateverActsOnIt) {
  Scenario scene = thrown_disk(GetParam());
  scene.disks[0].fixed = true;
  scene.disk_forces = {Vec3(4, -2, 3)};
  Simulation run(scene);
  run.run_for(1);
  EXPECT_EQ(distance(run.world.disks.velocity[0], Vec3(0.3, 0.7, -2)), 0);
}

// Perfectly inelastic: the falling disk stays where it lands.
TEST_P(FreeFall, EndsAtRestOnTheFloor) {
  Scenario scene = empty_scene(GetParam());
  scene.box.floor = true;
  scene.gravity = Vec2(0, -1);
  scene.disks.push_back({.position = {0, 1}});
  Simulation run(scene);
  run.run_for(2);
  EXPECT_NEAR(run.world.disks.position[0].y(), 0.5, tolerance::solved());
  EXPECT_LE(run.world.disks.velocity[0].norm(), tolerance::solved());
  EXPECT_NEAR(contact_force_on(run.world, wall_body(0)).y(), -1, tolerance::solved());
}

}  // namespace
}  // namespace quicksand
