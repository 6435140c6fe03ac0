// Which starts are taken as they are: a step of those costs a residual, of all others a solution.
#include "core/problem/rest.h"

#include <gtest/gtest.h>

#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/step/lengths.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

// A chain that hangs, and beside it what `moves`: how many steps of twenty are solved by more than a look.
std::int64_t solved(Disk moves) {
  Scenario scene = hanging_chain(Method::automatic, 10, 100);
  moves.position = {5, 0};
  scene.disks.push_back(moves);
  scene.phases = {{SettlePhase{.max_time = 1e3, .until_rest = false}, 1e-2}};
  Protocol protocol(scene, make_world(scene));
  for (int k = 0; k < 20; ++k) protocol.advance();
  const WorkClock::Counts before = protocol.clock().counts;
  for (int k = 0; k < 20; ++k) protocol.advance();
  const WorkClock::Counts& after = protocol.clock().counts;
  EXPECT_EQ(after.solutions, before.solutions + 20) << "it moves, so all steps are computed";
  return after.solutions - before.solutions - (after.by_stage[0] - before.by_stage[0]);
}

TEST(StartTakenAsItIs, OfAChainBesideAGrainThatFalls) { EXPECT_EQ(solved({}), 0); }

TEST(StartTakenAsItIs, OfAChainBesideAGrainThatIsMoved) {
  EXPECT_EQ(solved({.velocity = {1, 0}, .fixed = true}), 0);
}

// Forces are solved to a share of the strongest bond, here far more than the weight of a grain: what that hides at the
// contacts of a bonded grain is no reason to hold one in the air.
TEST(Rest, IsNotThatOfAGrainInTheAir) {
  Scenario scene = column(Method::automatic, 1, paper_law(1e11));
  scene.initial_bonds = InitialBonds::touching;
  scene.solver.tolerance = 1e-5;
  scene.step.dt = 1e-2;
  scene.disks.push_back({.position = {5, 8}});
  scene.phases = {{SettlePhase{.max_time = 1, .until_rest = false}}};
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() == Progress::running) {
  }
  const World& world = protocol.world();
  EXPECT_NEAR(world.disks.velocity[1].y(), -world.time, tolerance::rounding(10));
  EXPECT_TRUE(world.disks.velocity[0].isZero(0)) << "bonded to the floor";
}

// The momentum that a grain gains in a step is within the error of a contact this strong.
TEST(Rest, IsNotThatOfABondedPairThatFalls) {
  Scenario scene;
  scene.gravity = Vec2(0, -1);
  scene.box = {.sides = Sides::open, .floor = false};
  scene.grain_law.cohesion_force = 1e11;
  scene.initial_bonds = InitialBonds::touching;
  scene.disks = {{.position = {0, 0}}, {.position = {1, 0}}};
  scene.phases = {{SettlePhase{.max_time = 1, .until_rest = false}, 1e-2}};
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() == Progress::running) {
  }
  for (const Vec3& v : protocol.world().disks.velocity) EXPECT_NEAR(v.y(), -1, 1e-3);
}

// Nor does a body sink into the floor because another, far away, is pressed a million million times as hard.
TEST(Rest, IsNotInTheFloor) {
  Scenario scene;
  scene.gravity = Vec2(0, -1);
  scene.box = {.sides = Sides::open};
  scene.disks = {{.position = {3, 1}}, {.position = {3000, 5000}, .density = 1e6}};
  World world = make_world(scene);
  world.disks.applied[1] = {0, 1e12, 0};
  scene.phases = {{SettlePhase{.max_time = 3, .until_rest = false}, 1e-2}};
  Protocol protocol(scene, world);
  while (protocol.advance() == Progress::running) {
  }
  EXPECT_NEAR(protocol.world().disks.position[0].y(), 0.5, kPlainGapTolerance);
}

}  // namespace
}  // namespace quicksand
