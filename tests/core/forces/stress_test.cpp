// Mean stresses against what the balance of forces makes of them.
#include "core/forces/stress.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "core/measures/measures.h"
#include "core/scene/make_world.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

Stress total(const World& world) {
  Stress sum;
  for (const Stress& grain : stress_times_area(world)) sum += grain;
  return sum;
}

// Of bodies at rest on a floor at y = 0, the sum of force times arm is that of weight times height: the virial theorem.
TEST(StressOf, AColumnAtRestIsItsPotentialEnergyOverTheArea) {
  Scenario scene = column(Method::automatic, 9);
  scene.box.sides = Sides::periodic;
  scene.box.width = 3;
  Simulation run(scene);
  run.advance(3);
  const double energy = energies(run.world).potential;
  EXPECT_NEAR(energy, 81 / 2.0, tolerance::solved(energy));
  EXPECT_NEAR(total(run.world).yy, energy, tolerance::solved(energy));
  const Stress mean = mean_stress(run.world).value();
  EXPECT_NEAR(mean.yy, energy / (3 * 9), tolerance::solved());
  EXPECT_NEAR(mean.xx, 0, tolerance::solved());
  EXPECT_NEAR(mean.xy, 0, tolerance::solved());
}

// Held by friction and rolling friction, the disk pushes the floor, which is below it, towards +x: half of what the mean of
// both shears counts, since the moment of rolling friction balances the other.
TEST(StressOf, WhatGravityDrawsToTheRightIsANegativeShear) {
  Scenario scene = column(Method::automatic, 1, paper_law());
  scene.gravity = Vec2(0.05, -1);
  Simulation run(scene);
  run.advance(3);
  const double radius = 0.5;
  EXPECT_NEAR(total(run.world).xy, -0.05 * radius / 2, tolerance::solved());
  EXPECT_NEAR(total(run.world).yy, radius, tolerance::solved());
}

TEST(StressOf, AHangingChainIsATension) {
  Simulation run(hanging_chain(Method::automatic, 4, 100));
  run.advance(3);
  // Bond k from above bears the k-th disk and all below it, at both its ends by a radius; disk 0, fixed, is a grain too.
  const double tension = 4 + 3 + 2 + 1;
  EXPECT_NEAR(total(run.world).yy, -tension, tolerance::solved(tension));
}

TEST(StressOf, AHeapOfBondsAtRestIsItsPotentialEnergyOverTheArea) {
  Scenario scene = falling_cluster(Method::automatic, 25, 3, paper_law(100));
  scene.box.sides = Sides::periodic;
  scene.box.width = 6.5;
  Simulation run(scene);
  run.run_for(30);
  const double energy = energies(run.world).potential;
  EXPECT_GT(energy, 10);
  EXPECT_NEAR(total(run.world).yy, energy, tolerance::solved(energy));
}

// A force along n at the contact of two unit disks: half a diameter times n n f on each.
TEST(StressOf, AContactHasTheDirectionsOfItsNormalAndItsForce) {
  Scenario scene = empty_scene(Method::automatic);
  const double c = std::numbers::sqrt2 / 2;
  scene.disks = {{.position = {0, 5}}, {.position = {c, 5 + c}}};
  World world = make_world(scene);
  world.impulse_dt = 0.5;
  world.contacts = {{.pair = {0, 1}, .normal = {c, c}, .impulse = {2, 0, 7}}};
  for (const Stress& grain : stress_times_area(world)) {
    EXPECT_NEAR(grain.xx, 0.5 * 4 / 2, tolerance::rounding());
    EXPECT_NEAR(grain.yy, 0.5 * 4 / 2, tolerance::rounding());
    EXPECT_NEAR(grain.xy, 0.5 * 4 / 2, tolerance::rounding());
  }
  world.contacts[0].impulse = {0, 2, 0};
  for (const Stress& grain : stress_times_area(world)) {
    EXPECT_NEAR(grain.xx, -0.5 * 4 / 2, tolerance::rounding()) << "friction along (-1, 1)";
    EXPECT_NEAR(grain.yy, 0.5 * 4 / 2, tolerance::rounding());
    EXPECT_NEAR(grain.xy, 0, tolerance::rounding());
  }
}

// Two smooth walls, one fixed and one pressed towards it, that stand far inside the box.
TEST(StressOf, ARowBetweenListedWallsBearsTheirForceOverTheHeight) {
  Scenario scene = bonded_row(3);
  scene.box.width = 50;
  scene.box.height = 5;
  for (Disk& disk : scene.disks) disk.position.y() = 0.5;
  scene.walls = {
      {.point = {0, 0}, .normal = {1, 0}, .role = WallRole::side},
      {.point = {3, 0}, .normal = {-1, 0}, .mass = 1, .force = 7, .role = WallRole::side}};
  Simulation run(scene);
  run.advance(3);
  EXPECT_NEAR(mean_stress(run.world).value().xx, 7, tolerance::solved());
}

// Whether a grain is called an intruder does not change the balance of forces.
TEST(StressOf, AnIntruderBearsItsShare) {
  for (const DiskRole role : {DiskRole::grain, DiskRole::intruder}) {
    Scenario scene = column(Method::automatic, 3);
    scene.box.sides = Sides::periodic;
    scene.box.width = 2;
    scene.disks[1].role = role;
    Simulation run(scene);
    run.advance(3);
    EXPECT_NEAR(mean_stress(run.world).value().yy, energies(run.world).potential / (2 * 3),
                tolerance::solved());
  }
}

TEST(StressOf, APackingWithoutSidesHasNoMeanBecauseItsAreaIsUnknown) {
  Simulation run(column(Method::automatic, 3));
  run.advance(3);
  EXPECT_FALSE(mean_stress(run.world));
}

TEST(ContactPressure, IsTheCompressiveForceOverTheCircumference) {
  Simulation run(column(Method::automatic, 3));
  EXPECT_EQ(contact_pressure(run.world), std::vector<double>(3, 0)) << "before any step";
  run.advance(3);
  const std::vector<double> pressure = contact_pressure(run.world);
  EXPECT_NEAR(pressure[0], (3 + 2) / std::numbers::pi, tolerance::solved());
  EXPECT_NEAR(pressure[1], (2 + 1) / std::numbers::pi, tolerance::solved());
  EXPECT_NEAR(pressure[2], 1 / std::numbers::pi, tolerance::solved());
}

TEST(ContactPressure, IsZeroUnderTension) {
  Simulation run(hanging_chain(Method::automatic, 3, 10));
  run.advance(3);
  for (double p : contact_pressure(run.world)) EXPECT_NEAR(p, 0, tolerance::solved());
  EXPECT_EQ(count_neighbours(run.world).loaded, (std::vector<int>{1, 2, 2, 1})) << "bonds count";
}

}  // namespace
}  // namespace quicksand
