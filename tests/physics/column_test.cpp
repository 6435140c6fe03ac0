#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Column);

// Force that carries grain k and all above it.
double force_below(const World& world, int k) {
  return k == 0 ? contact_force(world, {0, wall_body(0)}).norm()
                : contact_force(world, {k - 1, k}).norm();
}

void expect_forces_grow_with_depth(const Simulation& run, int n, double load) {
  EXPECT_EQ(run.unconverged, 0);
  for (int k = 0; k < n; ++k)
    EXPECT_NEAR(force_below(run.world, k), load + n - k, tolerance::solved()) << "grain " << k;
}

TEST_P(Column, ContactForcesGrowLinearlyWithDepth) {
  Simulation run(column(GetParam(), 20));
  run.advance(10);
  expect_forces_grow_with_depth(run, 20, 0);
}

TEST_P(Column, BondsDoNotChangeTheForcesOfAColumnAtRest) {
  Scenario scene = column(GetParam(), 20, paper_law(50));
  scene.initial_bonds = InitialBonds::touching;
  Simulation run(scene);
  run.advance(10);
  ASSERT_EQ(run.world.bonds.list.size(), 20U);
  expect_forces_grow_with_depth(run, 20, 0);
}

TEST_P(Column, UnequalGrainsAreCarriedByWeight) {
  Scenario scene = empty_scene(GetParam());
  scene.box.floor = true;
  scene.gravity = Vec2(0, -1);
  scene.disks = {{.position = {0, 2}, .radius = 2},
                 {.position = {0, 4.25}, .radius = 0.25, .density = 40}};
  Simulation run(scene);
  run.advance(10);
  EXPECT_NEAR(force_below(run.world, 1), 10, tolerance::solved());
  EXPECT_NEAR(force_below(run.world, 0), 26, tolerance::solved());
}

TEST_P(Column, HasTheSameForcesWhenTheTimeStepChanges) {
  Simulation run(column(GetParam(), 10));
  for (double dt : {1e-2, 1e-3, 3e-3, 1e-4}) {
    run.step.dt = dt;
    run.advance(3);
    expect_forces_grow_with_depth(run, 10, 0);
  }
}

// The impulses of the warm start scale with the step, so a column at rest starts from its solution.
TEST_P(Column, NeedsNoIterationAtRestEvenWhenTheTimeStepChanges) {
  Simulation run(column(GetParam(), 10));
  run.advance(3);
  run.solver.tolerance = 1e-6;
  for (double dt : {1e-2, 1e-3, 5e-3}) {
    run.step.dt = dt;
    run.advance();
    EXPECT_EQ(run.last.solve.iterations, 0) << dt;
  }
}

TEST_P(Column, PistonPressesWithItsForceAndItsWeight) {
  Scenario scene = column(GetParam(), 5);
  scene.walls.push_back(
      {.point = {0, 5}, .normal = {0, -1}, .mass = 3, .force = 7, .role = WallRole::piston});
  Simulation run(scene);
  run.advance(50);
  expect_forces_grow_with_depth(run, 5, 10);
  EXPECT_NEAR(contact_force(run.world, {4, wall_body(1)}).norm(), 10, tolerance::solved());
  EXPECT_NEAR(run.world.walls[1].point.y(), 5, tolerance::solved());
}

TEST_P(Column, PistonFallsOnTheColumnAndStaysThere) {
  Scenario scene = column(GetParam(), 3);
  scene.walls.push_back(
      {.point = {0, 3.5}, .normal = {0, -1}, .mass = 2, .force = 4, .role = WallRole::piston});
  Simulation run(scene);
  // Its acceleration is g + F/m = 3.
  run.advance(10);
  EXPECT_NEAR(run.world.walls[1].velocity.y(), -0.3, tolerance::rounding(10));
  run.run_for(2);
  EXPECT_NEAR(run.world.walls[1].point.y(), 3, tolerance::solved());
  expect_forces_grow_with_depth(run, 3, 6);
}

// Between two side pistons: the force along the normal presses, without weight sideways.
TEST_P(Column, SidePistonPressesARowAgainstAWall) {
  Scenario scene = empty_scene(GetParam());
  for (int k = 0; k < 4; ++k) scene.disks.push_back({.position = {0.5 + k, 0}});
  scene.walls = {{.point = {0, 0}, .normal = {1, 0}},
                 {.point = {4, 0}, .normal = {-1, 0}, .mass = 1, .force = 9}};
  Simulation run(scene);
  run.advance(10);
  EXPECT_NEAR(contact_force(run.world, {0, wall_body(0)}).x(), -9, tolerance::solved());
  for (int k = 1; k < 4; ++k)
    EXPECT_NEAR(contact_force(run.world, {k - 1, k}).norm(), 9, tolerance::solved());
}

TEST_P(Column, AWallWithPrescribedMotionLiftsWhatLiesOnIt) {
  Scenario scene = column(GetParam(), 3);
  scene.box.floor = false;
  scene.walls.push_back({.velocity = {0, 0.5}});
  Simulation run(scene);
  run.run_for(1);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(run.world.disks.velocity[k].y(), 0.5, tolerance::solved());
    EXPECT_NEAR(run.world.disks.position[k].y(), 1 + k, tolerance::solved(10));
  }
}

}  // namespace
}  // namespace quicksand
