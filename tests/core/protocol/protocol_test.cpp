#include "core/protocol/protocol.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/measures/measures.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/world/extent.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(RunOfPhases);

Scenario with_phases(Method method, std::vector<Phase> phases) {
  Scenario scene = small_collapse(method);
  scene.solver.max_iterations = 5000;
  scene.phases = std::move(phases);
  return scene;
}

struct Finished {
  explicit Finished(const Scenario& scene) : protocol(scene, make_world(scene)) {
    while (last != Progress::finished && last != Progress::failed) last = protocol.advance();
  }
  Protocol protocol;
  Progress last = Progress::running;
};

TEST_P(RunOfPhases, DepositEndsByNumber) {
  const Finished run(with_phases(GetParam(), {{DepositPhase{.grains = 12, .interval = 0.02}}}));
  EXPECT_EQ(run.last, Progress::finished);
  const World& world = run.protocol.world();
  EXPECT_EQ(world.disks.size(), 12);
  EXPECT_EQ(run.protocol.state().memory.at("dropped"), 12);
  // One grain every interval, the first at once, and the last has its interval too.
  EXPECT_NEAR(world.time, 12 * 0.02, tolerance::rounding());
  EXPECT_GE(world.bonds.formed, 12) << "every grain sticks where it lands";
}

// Whatever it is called: it is in nobody's way.
TEST_P(RunOfPhases, GrainsFallOnAFloor) {
  Scenario scene = with_phases(GetParam(), {{DepositPhase{.grains = 2, .interval = 0.02}}});
  scene.walls = {{.point = {0, 0.5}, .normal = {0, 1}, .role = WallRole::piston}};
  EXPECT_EQ(Finished(scene).last, Progress::finished);
}

// Grains come at multiples of the interval, not of the steps that happen to follow them.
TEST_P(RunOfPhases, DepositKeepsItsRateWhenTheStepDoesNotDivideTheInterval) {
  const Finished run(
      with_phases(GetParam(), {{DepositPhase{.grains = 20, .interval = 0.025}, 1e-2}}));
  EXPECT_NEAR(run.protocol.world().time, 20 * 0.025, tolerance::rounding());
}

TEST_P(RunOfPhases, DepositEndsByHeightAndStaysBelowIt) {
  const Finished run(with_phases(GetParam(), {{DepositPhase{.height = 4, .interval = 0.02}}}));
  const World& world = run.protocol.world();
  EXPECT_EQ(run.protocol.state().memory.at("full"), 1);
  EXPECT_GT(world.disks.size(), 10);
  EXPECT_LE(packing_top(world), 4 + 1e-3) << "settled grains only sink";
  EXPECT_GT(packing_top(world), 3);
}

TEST_P(RunOfPhases, DepositWithoutIntervalMakesNoStep) {
  const Finished run(with_phases(GetParam(), {{DepositPhase{.grains = 30, .interval = 0}}}));
  EXPECT_EQ(run.protocol.world().step, 0);
  EXPECT_EQ(run.protocol.world().disks.size(), 30);
  EXPECT_EQ(run.protocol.world().bonds.formed, 30);
}

TEST_P(RunOfPhases, DepositedGrainsStartWithTheDropVelocityAndNeverOverlap) {
  const Finished run(
      with_phases(GetParam(), {{DepositPhase{.grains = 40, .interval = 0, .drop_velocity = 3}}}));
  const World& world = run.protocol.world();
  EXPECT_GE(-measure(world).max_overlap, -1e-12);
  for (const Vec3& v : world.disks.velocity) EXPECT_EQ(distance(v, Vec3(0, -3, 0)), 0);
}

TEST_P(RunOfPhases, SettleEndsAtRest) {
  const SettlePhase settle{.rest_speed = 1e-2, .rest_time = 0.2, .max_time = 200};
  const Finished run(
      with_phases(GetParam(), {{DepositPhase{.grains = 8, .interval = 0.02}}, {settle}}));
  EXPECT_EQ(run.last, Progress::finished);
  EXPECT_LE(measure(run.protocol.world()).max_speed, 1e-2);
  EXPECT_LT(run.protocol.world().time, 200);
}

// A fixed disk that moves is a drive, like a wall without mass: nothing waits for it.
TEST_P(RunOfPhases, WhatIsFixedAndMovesDoesNotKeepTheRestFromBeingAtRest) {
  Scenario scene = with_phases(GetParam(), {{SettlePhase{.rest_speed = 1e-2, .max_time = 5}}});
  scene.disks = {{.position = {2, 0.5}}, {.position = {2, 8}, .velocity = {0.1, 0}, .fixed = true}};
  const Finished run(scene);
  EXPECT_LT(run.protocol.world().time, 2);
}

TEST_P(RunOfPhases, SettleLastsExactlyItsTimeIfItShallNotWaitForRest) {
  const Finished run(
      with_phases(GetParam(), {{SettlePhase{.max_time = 0.37, .until_rest = false}, 1e-2}}));
  EXPECT_EQ(run.protocol.world().step, 37);
}

// A million steps of 1e-3 add up to 1000 - 1.7e-8.
TEST(StageOfALongRun, AMomentIsDueWithTheStepThatReachesIt) {
  World world;
  ProtocolState state;
  const Stage stage{world, state};
  const auto steps = [&](int count, double dt) {
    world.impulse_dt = dt;
    for (int k = 0; k < count; ++k) world.time += dt;
  };
  steps(999'999, 1e-3);
  EXPECT_FALSE(stage.due(1000, 1000));
  steps(1, 1e-3);
  EXPECT_TRUE(stage.due(1000, 1000));
  const double begin = world.time, span = 1e-5;
  EXPECT_FALSE(stage.due(begin + span, span));
  steps(999, 1e-8);
  EXPECT_FALSE(stage.due(begin + span, span));
  steps(1, 1e-8);
  EXPECT_TRUE(stage.due(begin + span, span));
}

TEST_P(RunOfPhases, AShortPhaseHasAllItsStepsHoweverLateItComes) {
  Scenario scene =
      with_phases(GetParam(), {{SettlePhase{.max_time = 1000, .until_rest = false}, 1},
                               {SettlePhase{.max_time = 1e-6, .until_rest = false}, 1e-7}});
  scene.step.max_turn.reset();
  EXPECT_EQ(Finished(scene).protocol.world().step, 1000 + 10);
}

TEST_P(RunOfPhases, SaysWhetherAPhaseEndedBeforeItCameToRest) {
  const auto missed = [](const SettlePhase& settle) {
    const DepositPhase grains{.grains = 3, .interval = 0.02};
    return Finished(with_phases(GetParam(), {{grains}, {settle}})).protocol.missed_rest();
  };
  EXPECT_FALSE(missed({.rest_speed = 0.1, .max_time = 50}));
  EXPECT_TRUE(missed({.rest_speed = 0.1, .max_time = 0.1}));
  EXPECT_TRUE(missed({.rest_speed = 1e3, .rest_time = 1, .max_time = 0.5}))
      << "slow for half as long";
  EXPECT_FALSE(missed({.max_time = 0.1, .until_rest = false}));
}

TEST_P(RunOfPhases, NothingBondsWhileSettlingUnlessTheSceneSaysSo) {
  for (bool bonding : {false, true}) {
    Scenario scene = with_phases(
        GetParam(), {{SettlePhase{.max_time = 1, .until_rest = false, .bonding = bonding}}});
    scene.disks.push_back({.position = {5, 0.7}});
    EXPECT_EQ(Finished(scene).protocol.world().bonds.formed, bonding ? 1 : 0);
  }
}

TEST_P(RunOfPhases, PushPlacesTheIntruderOnTheSurfaceAndPushes) {
  Scenario scene = with_phases(
      GetParam(),
      {{DepositPhase{.grains = 25, .interval = 0}},
       {PushPhase{.diameter = 3, .density = 0.5, .force = 200, .x = 4.0, .max_time = 0.3}, 1e-3}});
  Protocol protocol(scene, make_world(scene));
  ASSERT_EQ(finish_phase(protocol), Progress::phase_ended);
  const double top = packing_top(protocol.world());
  const auto bonds = static_cast<std::int64_t>(protocol.world().bonds.list.size());
  protocol.advance();
  const World& world = protocol.world();
  const int intruder = world.intruder();
  ASSERT_EQ(intruder, 25);
  EXPECT_EQ(world.disks.radius[intruder], 1.5);
  EXPECT_EQ(world.disks.mass[intruder], 4.5);
  EXPECT_EQ(distance(world.disks.applied[intruder], Vec3(0, -200, 0)), 0);
  EXPECT_NEAR(world.disks.position[intruder].x(), 4, 0.01);
  EXPECT_LE(world.disks.position[intruder].y(), top + 1.5);
  EXPECT_EQ(world.bonds.initial, bonds);
  EXPECT_FALSE(world.bonding);
  double nearest = 1;
  for (int i = 0; i < 25; ++i) nearest = std::min(nearest, world.gap({i, intruder}));
  EXPECT_NEAR(nearest, 0, 1e-3) << "it lies on a grain";
  const double start = world.disks.position[intruder].y();
  while (protocol.advance() == Progress::running) {
  }
  EXPECT_LT(protocol.world().disks.position[intruder].y(), start - 0.05);
  EXPECT_LT(measure(protocol.world()).remaining_bond_fraction, 1);
}

// An intruder that cannot move, beside a grain that falls all the time.
Scenario held_intruder(Method method, RestOf until) {
  Scenario scene = column(method, 1, paper_law());
  scene.box.width = 10;
  scene.disks.push_back({.position = {7, 3}, .velocity = {0, 9}});
  scene.phases = {
      {PushPhase{.force = 50, .x = 0.0, .rest_time = 0.1, .max_time = 0.5, .until = until}}};
  return scene;
}

TEST_P(RunOfPhases, PushEndsAtTheRestOfTheIntruderAloneIfTheSceneSaysSo) {
  const Finished alone(held_intruder(GetParam(), RestOf::driven));
  EXPECT_NEAR(alone.protocol.world().time, 0.1 + alone.protocol.world().impulse_dt,
              tolerance::rounding())
      << "from the first step on";
  EXPECT_NEAR(Finished(held_intruder(GetParam(), RestOf::all)).protocol.world().time, 0.5,
              tolerance::rounding());
}

TEST_P(RunOfPhases, ForceOfAPushEndsWithItOnlyIfItIsReleased) {
  for (const bool release : {false, true}) {
    Scenario scene = held_intruder(GetParam(), RestOf::driven);
    std::get<PushPhase>(scene.phases[0].kind).release = release;
    const Finished run(scene);
    EXPECT_EQ(run.protocol.world().disks.applied[2].y(), release ? 0 : -50);
  }
}

TEST_P(RunOfPhases, APhaseMayHaveItsOwnTolerance) {
  Scenario scene = small_collapse(GetParam());
  scene.step.stop_if_unconverged = true;
  scene.step.max_halvings = 0;
  scene.solver.max_iterations = 3000;
  scene.solver.tolerance = 1e-300;  // out of reach
  scene.phases.resize(1);
  EXPECT_EQ(Finished(scene).last, Progress::failed);
  scene.phases[0].solver_tolerance = 1e-3;
  const Finished run(scene);
  EXPECT_EQ(run.last, Progress::finished);
  EXPECT_LE(run.protocol.state().worst_residual, 1e-3);
}

TEST_P(RunOfPhases, PhasesFollowEachOtherWithTheirOwnSteps) {
  Scenario scene = small_collapse(GetParam());
  Protocol protocol(scene, make_world(scene));
  for (double dt : {1e-2, 5e-3, 2e-3}) {
    ASSERT_TRUE(protocol.phase());
    protocol.advance();
    EXPECT_EQ(protocol.world().impulse_dt, dt);
    EXPECT_EQ(finish_phase(protocol), Progress::phase_ended);
    EXPECT_LE(protocol.phase_progress(), 1);
  }
  EXPECT_EQ(protocol.phase(), nullptr);
  EXPECT_EQ(protocol.advance(), Progress::finished);
  EXPECT_EQ(protocol.phase_progress(), 1);
  EXPECT_EQ(protocol.advance(), Progress::finished) << "and stays so";
}

TEST_P(RunOfPhases, UnconvergedStepsAreCountedAndBreakNothing) {
  Scenario scene = small_collapse(GetParam());
  scene.solver.max_iterations = scene.solver.max_factorisations = 1;
  const Finished run(scene);
  EXPECT_EQ(run.last, Progress::finished);
  EXPECT_GT(run.protocol.state().unconverged_steps, 0);
  EXPECT_EQ(run.protocol.state().broken_in_unconverged, 0);
}

TEST_P(RunOfPhases, ARunThatMustConvergeStopsAndSaysWhy) {
  Scenario scene = small_collapse(GetParam());
  scene.step.stop_if_unconverged = true;
  scene.step.max_halvings = 2;
  scene.solver.tolerance = 1e-300;
  const Finished run(scene);
  EXPECT_EQ(run.last, Progress::failed);
  EXPECT_NE(run.protocol.failure().find("did not converge in step"), std::string::npos);
  EXPECT_EQ(run.protocol.state().unconverged_steps, 0) << "none was taken";
}

TEST_P(RunOfPhases, ARunThatIsNotFiniteStopsAndNamesTheBody) {
  Scenario scene = column(GetParam(), 3);
  scene.phases = {{SettlePhase{.max_time = 1}}};
  World world = make_world(scene);
  world.disks.applied[2].x() = std::numeric_limits<double>::infinity();
  Protocol protocol(scene, world);
  EXPECT_EQ(protocol.advance(), Progress::failed);
  EXPECT_NE(protocol.failure().find("body 2"), std::string::npos) << protocol.failure();
}

TEST_P(RunOfPhases, SameSeedSameHashOtherSeedOtherHash) {
  std::set<std::uint64_t> hashes;
  for (std::uint64_t seed : {1, 2, 3}) {
    const Finished first(small_collapse(GetParam(), seed)), again(small_collapse(GetParam(), seed));
    EXPECT_EQ(world_hash(first.protocol.world()), world_hash(again.protocol.world()));
    hashes.insert(world_hash(first.protocol.world()));
  }
  EXPECT_EQ(hashes.size(), 3U);
}

}  // namespace
}  // namespace quicksand
