// What a person does to a run under way.
#include <gtest/gtest.h>

#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"

namespace quicksand {
namespace {

Scenario scene_of(std::vector<Phase> phases) {
  Scenario scene = small_collapse(Method::automatic);
  scene.phases = std::move(phases);
  return scene;
}

Phase phase_of(decltype(Phase::kind) kind) {
  Phase phase;
  phase.kind = std::move(kind);
  return phase;
}

const Phase kDeposit = phase_of(DepositPhase{.grains = 12, .interval = 0.02});
const Phase kSettle = phase_of(SettlePhase{.max_time = 5, .until_rest = false});

// Before the first step of a search.
struct PullUnderWay {
  Scenario scene = scene_of({kDeposit, phase_of(PushPhase{.force = 1, .max_time = 0.1}),
                             phase_of(PullPhase{.trials = {.first_force = 1e4}})});
  Protocol protocol{scene, make_world(scene)};
  PullUnderWay() {
    finish_phase(protocol);
    finish_phase(protocol);
  }
};

TEST(PhaseByHand, EndsThePresentOneAndComesBeforeThoseThatFollow) {
  const Scenario scene = scene_of({kDeposit, kSettle, kSettle});
  Protocol protocol(scene, make_world(scene));
  finish_phase(protocol);
  protocol.advance();  // in the first settle
  ASSERT_EQ(protocol.state().phase, 1);
  protocol.begin_phase(phase_of(PushPhase{.force = 10, .max_time = 0.1}));
  EXPECT_EQ(protocol.state().phase, 2);
  protocol.advance();
  EXPECT_GE(protocol.world().intruder(), 0);
  finish_phase(protocol);
  EXPECT_EQ(phase_name(*protocol.phase()), "settle");
  EXPECT_EQ(protocol.scenario().phases.size(), 4U);
}

TEST(PhaseByHand, GoesOnAfterTheLast) {
  const Scenario scene = scene_of({kDeposit});
  Protocol protocol(scene, make_world(scene));
  finish_phase(protocol);
  ASSERT_EQ(protocol.phase(), nullptr);
  protocol.begin_phase(phase_of(DepositPhase{.grains = 3, .interval = 0.02}));
  finish_phase(protocol);
  EXPECT_EQ(protocol.world().disks.size(), 15);
}

TEST(PhaseByHand, ASearchThatIsLeftReturnsToItsBase) {
  PullUnderWay pull;
  Protocol& protocol = pull.protocol;
  const auto before = protocol.world().disks.position;
  for (int i = 0; i < 5; ++i) protocol.advance();
  ASSERT_NE(protocol.world().disks.position, before) << "a trial moves it";
  protocol.begin_phase(kSettle);
  EXPECT_EQ(protocol.world().disks.position, before);
}

TEST(ChangeByHand, LawsHoldFromTheNextStepAndBodiesStay) {
  Scenario scene = scene_of({kDeposit, kSettle});
  Protocol protocol(scene, make_world(scene));
  finish_phase(protocol);
  scene.grain_law.friction = 0.7;
  scene.gravity = Vec2(0.5, -1);
  protocol.change(scene);
  EXPECT_EQ(protocol.world().disks.size(), 12);
  EXPECT_EQ(protocol.world().grain_law.friction, 0.7);
  EXPECT_EQ(protocol.world().wall_law.friction, 0.7)
      << "a wall's law follows unless it has its own";
  EXPECT_EQ(protocol.world().gravity, Vec2(0.5, -1));
}

TEST(ChangeByHand, AnotherPushForceActsAtOnce) {
  Scenario scene = scene_of({kDeposit, phase_of(PushPhase{.force = 1, .max_time = 5})});
  Protocol protocol(scene, make_world(scene));
  finish_phase(protocol);
  protocol.advance();
  std::get<PushPhase>(scene.phases[1].kind).force = 50;
  protocol.change(scene);
  EXPECT_EQ(protocol.world().disks.applied[protocol.world().intruder()], Vec3(0, -50, 0));
}

TEST(PhaseByHand, BondingCanBeTurnedOnUnderWay) {
  Scenario scene = scene_of({kDeposit, kSettle});
  Protocol protocol(scene, make_world(scene));
  finish_phase(protocol);
  protocol.advance();
  ASSERT_FALSE(protocol.world().bonding);
  std::get<SettlePhase>(scene.phases[1].kind).bonding = true;
  protocol.change(scene);
  EXPECT_TRUE(protocol.world().bonding);
}

// What is changed beside it does not take it away.
TEST(ForceByHand, OnAnIntruderOutlastsOtherChanges) {
  Scenario scene = scene_of({kDeposit, phase_of(PushPhase{.force = 10, .max_time = 5})});
  Protocol protocol(scene, make_world(scene));
  finish_phase(protocol);
  protocol.advance();
  const int intruder = protocol.world().intruder();
  protocol.apply(intruder, Vec2(0, -777), {});
  scene.solver.tolerance *= 2;
  protocol.change(scene);
  EXPECT_EQ(protocol.world().disks.applied[intruder].y(), -777);
}

TEST(ForceByHand, ActsUntilItIsTakenAway) {
  Scenario scene = scene_of({kSettle});
  scene.gravity.reset();
  scene.disks = {{.position = {5, 3}}};
  Protocol protocol(scene, make_world(scene));
  protocol.apply(0, Vec2(2, 0), {});
  protocol.advance();
  const double dt = protocol.world().time;
  const double mass = 1;
  EXPECT_NEAR(protocol.world().disks.velocity[0].x(), 2 * dt / mass, 1e-12);
  protocol.apply(0, Vec2(0, 0), {});
  protocol.advance();
  EXPECT_NEAR(protocol.world().disks.velocity[0].x(), 2 * dt / mass, 1e-12);
}

// Angular acceleration is torque over m r^2/2 = 1/8; the force that acts stays.
TEST(TorqueByHand, TurnsADiskAndLeavesTheForceOnIt) {
  Scenario scene = scene_of({kSettle});
  scene.gravity.reset();
  scene.disks = {{.position = {5, 3}}};
  Protocol protocol(scene, make_world(scene));
  protocol.apply(0, Vec2(2, 0), {});
  protocol.apply(0, {}, 3);
  protocol.advance();
  const double dt = protocol.world().time;
  EXPECT_NEAR(protocol.world().disks.velocity[0].x(), 2 * dt, 1e-12);
  EXPECT_NEAR(protocol.world().disks.velocity[0].z(), 8 * 3 * dt, 1e-12);
}

TEST(ChangeByHand, LawsThatChangeDuringASearchAreThoseOfItsResult) {
  PullUnderWay pull;
  Scenario& scene = pull.scene;
  Protocol& protocol = pull.protocol;
  for (int i = 0; i < 5; ++i) protocol.advance();
  ASSERT_TRUE(protocol.state().search.trial_runs);
  scene.grain_law.cohesion_force = 3 * *scene.grain_law.cohesion_force;
  protocol.change(scene);
  EXPECT_FALSE(protocol.state().search.trial_runs) << "the trial was half of the old law";
  EXPECT_EQ(protocol.state().search.bracket.trials, 0);
  finish_phase(protocol);
  EXPECT_EQ(protocol.world().grain_law.cohesion_force, scene.grain_law.cohesion_force);
}

TEST(ChangeByHand, OfTheSolverLeavesTheTrialOfASearchAlone) {
  PullUnderWay pull;
  Scenario& scene = pull.scene;
  Protocol& protocol = pull.protocol;
  for (int i = 0; i < 5; ++i) protocol.advance();
  scene.solver.tolerance /= 2;
  protocol.change(scene);
  EXPECT_TRUE(protocol.state().search.trial_runs);
}

TEST(ChangeByHand, TouchesOfADepositUnderWayBondAsItSaysNow) {
  Scenario scene = scene_of({kDeposit});
  Protocol protocol(scene, make_world(scene));
  protocol.advance();
  ASSERT_FALSE(protocol.world().rebonding);
  std::get<DepositPhase>(scene.phases[0].kind).bonds = BondingTouch::every;
  protocol.change(scene);
  EXPECT_TRUE(protocol.world().rebonding);
}

TEST(PhaseByHand, KeepsTheGrainsOfAnAdiabaticDeposit) {
  const Scenario scene = scene_of(
      {phase_of(DepositPhase{.grains = 12, .interval = 0.02, .adiabatic = Adiabatic{}}), kSettle});
  Protocol protocol(scene, make_world(scene));
  for (int i = 0; i < 20; ++i) protocol.advance();
  const int grains = protocol.world().disks.size();
  ASSERT_GT(grains, 0);
  protocol.begin_phase(kSettle);
  EXPECT_EQ(protocol.world().disks.size(), grains);
}

}  // namespace
}  // namespace quicksand
