// Push, pull and shear on systems whose critical force is known.
#include "core/protocol/search.h"

#include <gtest/gtest.h>

#include <set>

#include "core/measures/critical_force.h"
#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(EntryForce);
QUICKSAND_PER_SOLVER(Pull);
QUICKSAND_PER_SOLVER(Shear);

// What is left when all phases are done.
struct SearchEnd {
  World world;
  std::vector<CriticalForce> forces;
};

SearchEnd searched(const Scenario& scene) {
  Protocol protocol(scene, make_world(scene));
  Progress progress = Progress::running;
  while (progress != Progress::finished && progress != Progress::failed)
    progress = protocol.advance();
  EXPECT_EQ(progress, Progress::finished) << protocol.failure();
  return {protocol.world(), protocol.state().critical_forces};
}

// Expects an interval of the relative width asked for, with the force in it.
void expect_around(const CriticalForce& found, double force, double tolerance) {
  ASSERT_TRUE(found.force_high);
  EXPECT_LE(found.force_low, force + tolerance::solved(force));
  EXPECT_GE(*found.force_high, force - tolerance::solved(force));
  EXPECT_LE(*found.force_high - found.force_low, tolerance * *found.force_high);
}

// An intruder of diameter 2 and density 0.5, mass 2, on the floor.
Scenario free_intruder(Method method) {
  Scenario scene = column(method, 0);
  scene.disks = {{.position = {0, 1}, .radius = 1, .density = 0.5, .role = DiskRole::intruder}};
  scene.phases = {{PullPhase{.trials = {.first_force = 0.7, .max_time = 20}, .distance = 1}, 1e-2}};
  return scene;
}

TEST_P(Pull, AFreeIntruderIsTakenOutByItsWeight) {
  const SearchEnd run = searched(free_intruder(GetParam()));
  ASSERT_EQ(run.forces.size(), 1U);
  const CriticalForce& found = run.forces[0];
  expect_around(found, 2, 0.02);
  EXPECT_EQ(found.kind, SearchKind::pull);
  EXPECT_EQ(found.body, 0);
  EXPECT_EQ(found.undecided, 0);
}

// It lies above all else from the beginning, and yet it is out only when it has left the floor.
TEST_P(Pull, AnIntruderThatLiesOnTopIsNotYetOut) {
  Scenario scene = free_intruder(GetParam());
  std::get<PullPhase>(scene.phases[0].kind).distance.reset();
  expect_around(searched(scene).forces.at(0), 2, 0.02);
}

TEST_P(Pull, ABondedIntruderIsTakenOutByItsWeightAndTheCohesionForce) {
  Scenario scene = hanging_chain(GetParam(), 0, 50);
  scene.disks.push_back({.position = {0, 1}, .role = DiskRole::intruder});
  scene.phases = {{PullPhase{.trials = {.first_force = 1}, .distance = 3}, 1e-2}};
  const SearchEnd run = searched(scene);
  ASSERT_EQ(run.forces.size(), 1U);
  expect_around(run.forces[0], 51, 0.02);
}

TEST_P(Pull, EndsWithTheBodiesAndBondsThatItBeganWithAndALaterClock) {
  Scenario scene = hanging_chain(GetParam(), 0, 50);
  scene.disks.push_back({.position = {0, 1}, .role = DiskRole::intruder});
  scene.phases = {{PullPhase{.trials = {.first_force = 40}, .distance = 3}, 1e-2}};
  const World before = make_world(scene);
  World after = searched(scene).world;
  EXPECT_GT(after.time, 1);
  EXPECT_GT(after.step, 100);
  after.time = before.time;
  after.step = before.step;
  EXPECT_EQ(world_hash(after), world_hash(before));
  EXPECT_EQ(after.bonds.broken, 0);
}

TEST_P(Pull, AHeldTrialEndsAtRestLongBeforeItsTime) {
  Scenario scene = hanging_chain(GetParam(), 0, 50);
  scene.disks.push_back({.position = {0, 1}, .role = DiskRole::intruder});
  scene.phases = {{PullPhase{.trials = {.first_force = 40, .tolerance = 0.5, .max_time = 1000}}}};
  const SearchEnd run = searched(scene);
  EXPECT_EQ(run.forces.at(0).trials, 2);
  EXPECT_LT(run.world.time, 5);
}

TEST_P(Pull, ATrialThatEndsByItsTimeIsHeldAndCounted) {
  Scenario scene = free_intruder(GetParam());
  std::get<PullPhase>(scene.phases[0].kind) = {
      .trials = {.first_force = 4, .tolerance = 0.5, .max_time = 0.1}, .distance = 1};
  const SearchEnd run = searched(scene);
  const CriticalForce& found = run.forces.at(0);
  EXPECT_GT(found.force_low, 4) << "2 m g for 0.1 sqrt(d/g) do not lift it by 1 d";
  EXPECT_GT(found.undecided, 0);
  EXPECT_EQ(found.force_held, 0) << "no trial came to rest";
  EXPECT_FALSE(found.bracketed());
}

// A loose grain far from the pull rolls on for longer than a trial lasts.
TEST_P(Pull, ATrialMayEndWhenItsBodyRestsAndNoBondFails) {
  for (const RestOf until : {RestOf::all, RestOf::driven}) {
    Scenario scene = hanging_chain(GetParam(), 0, 50);
    scene.disks.push_back({.position = {0, 1}, .role = DiskRole::intruder});
    scene.disks.push_back({.position = {20, 0}, .velocity = {1, 100}});
    scene.phases = {
        {PullPhase{.trials = {.first_force = 40, .tolerance = 0.5, .max_time = 20, .until = until},
                   .distance = 3}}};
    const CriticalForce found = searched(scene).forces.at(0);
    EXPECT_EQ(found.bracketed(), until == RestOf::driven);
    EXPECT_EQ(found.undecided > 0, until == RestOf::all);
  }
}

TEST_P(Pull, AnIntruderUnderACeilingIsReportedWithoutAnUpperForce) {
  Scenario scene = free_intruder(GetParam());
  scene.walls.push_back({.point = {0, 2}, .normal = {0, -1}});
  const CriticalForce found = searched(scene).forces.at(0);
  EXPECT_FALSE(found.force_high);
  EXPECT_GT(found.force_low, 1e5);
}

TEST_P(Pull, OutIsAboveTheTopOfThePacking) {
  Scenario scene = free_intruder(GetParam());
  // A grain beside it, whose top is at 3.
  scene.disks.push_back({.position = {3, 2.5}, .fixed = true});
  std::get<PullPhase>(scene.phases[0].kind) = {.trials = {.first_force = 4, .tolerance = 0.5}};
  Protocol protocol(scene, make_world(scene));
  double highest = 0;
  while (protocol.advance() == Progress::running)
    highest = std::max(highest, protocol.world().disks.position[0].y() - 1);
  EXPECT_GT(highest, 3);
  EXPECT_LT(highest, 3.1);
  EXPECT_EQ(protocol.state().critical_forces.at(0).depth, 2);
  EXPECT_EQ(protocol.state().critical_forces.at(0).weight_above, 1);
}

// A grain that a bond holds at the side of a fixed one, too rough to roll: the bond's friction carries it, and an intruder
// of mass 0.5 that is pushed on its top, up to mu F_c = 15.
Scenario ledge(Method method, const PushPhase& push) {
  Scenario scene = pulled_pair(method, 0, 50);
  scene.gravity = Vec2(0, -1);
  scene.grain_law.rolling_friction = 1;
  scene.disk_forces.clear();
  scene.phases = {{push, 1e-2}};
  return scene;
}

PushPhase gentle_push() {
  return {.diameter = 1,
          .density = 0.5,
          .force = 10,
          .x = 1,
          .max_time = 20,
          .threshold = Threshold{.distance = 0.3}};
}

TEST_P(EntryForce, IsTheForceThatTheFrictionOfTheBondBelowDoesNotCarry) {
  const SearchEnd run = searched(ledge(GetParam(), gentle_push()));
  ASSERT_EQ(run.forces.size(), 1U);
  const CriticalForce& found = run.forces[0];
  expect_around(found, 15 - 1.5, 0.02);
  EXPECT_EQ(found.kind, SearchKind::push);
  EXPECT_EQ(found.body, 2);
  EXPECT_EQ(found.undecided, 0);
}

TEST_P(EntryForce, EndsWithTheIntruderOnTheSurfaceAndNoForceOnIt) {
  const SearchEnd run = searched(ledge(GetParam(), gentle_push()));
  const Disks& disks = run.world.disks;
  EXPECT_NEAR(disks.position[2].y(), 1, tolerance::rounding());
  EXPECT_EQ(disks.applied[2], Vec3(0, 0, 0));
  EXPECT_EQ(run.world.bonds.broken, 0);
  EXPECT_GT(run.world.time, 1);
}

TEST_P(EntryForce, WithoutADistanceTheIntruderEntersByItsDiameter) {
  PushPhase push = gentle_push();
  push.threshold = Threshold{.tolerance = 0.5};
  const Scenario scene = ledge(GetParam(), push);
  Protocol protocol(scene, make_world(scene));
  double lowest = 1;
  while (protocol.advance() == Progress::running)
    lowest = std::min(lowest, protocol.world().disks.position[2].y());
  // The step that goes past it ends the trial.
  EXPECT_GT(lowest, 0);
  EXPECT_LT(lowest, 0.2);
}

// A disk that is pressed in as any other shape meets the same bond.
TEST_P(EntryForce, OfADiskThatPenetratesIsThatOfAPush) {
  const PushPhase push = gentle_push();
  Scenario scene = ledge(GetParam(), push);
  const CriticalForce pushed = searched(scene).forces.at(0);
  PushPhase driven = push;
  driven.until = RestOf::driven;
  scene.phases = {{driven, 1e-2}};
  const CriticalForce of_driven = searched(scene).forces.at(0);
  scene.phases = {{PenetratePhase{.shape = DiskIntruder{.diameter = 1},
                                  .density = 0.5,
                                  .x = 1,
                                  .force = 10,
                                  .depth = 0.3,
                                  .max_time = 20,
                                  .threshold = CriticalDrive{}},
                   1e-2}};
  const SearchEnd run = searched(scene);
  ASSERT_EQ(run.forces.size(), 1U);
  EXPECT_EQ(run.forces[0].kind, SearchKind::penetrate);
  expect_around(run.forces[0], 15 - 1.5, 0.02);
  EXPECT_EQ(run.forces[0].force_high, of_driven.force_high);
  EXPECT_EQ(run.forces[0].force_low, pushed.force_low);
  EXPECT_EQ(run.world.disks.applied[2], Vec3(0, 0, 0));
}

// A search is not a push that missed its rest, and a changed force is none of the trial under way.
TEST(EntryForceSearch, IsNoPush) {
  Scenario scene = ledge(Method::automatic, gentle_push());
  Protocol protocol(scene, make_world(scene));
  protocol.advance();
  std::get<PushPhase>(scene.phases[0].kind).force = 11;
  protocol.change(scene);
  EXPECT_EQ(protocol.world().disks.applied[2].y(), -10);
  std::get<PushPhase>(scene.phases[0].kind).threshold.reset();
  protocol.change(scene);
  while (protocol.advance() == Progress::running) {
  }
  EXPECT_EQ(protocol.state().critical_forces.size(), 1U);
  EXPECT_FALSE(protocol.missed_rest());
}

// A disk held by one bond to a fixed one on its left.
Scenario bonded_grain(Method method, double cohesion) {
  Scenario scene = pulled_pair(method, 0, cohesion);
  ShearPhase shear{.depths = {0.5}, .distance = 2};
  shear.trials.first_force = 10;
  scene.phases = {{shear, 1e-2}};
  return scene;
}

TEST_P(Shear, AGrainHeldByOneBondMovesAtTheCohesionForce) {
  const SearchEnd run = searched(bonded_grain(GetParam(), 70));
  ASSERT_EQ(run.forces.size(), 1U) << "the other disk is fixed";
  const CriticalForce& found = run.forces[0];
  expect_around(found, 70, 0.05);
  EXPECT_EQ(found.kind, SearchKind::shear);
  EXPECT_EQ(found.body, 1);
  EXPECT_EQ(found.depth, 0.5);
}

Scenario lying_disk(Method method, const ContactLaw& law) {
  Scenario scene = column(method, 1, law);
  ShearPhase shear{.depths = {0.5}, .distance = 2};
  shear.trials.first_force = 1;
  shear.trials.rest_speed = 1e-5;  // what is slightly above the limit is slow, too
  scene.phases = {{shear, 1e-2}};
  return scene;
}

TEST_P(Shear, AHeavyRollerRollsAtTheRollingFriction) {
  const SearchEnd run = searched(lying_disk(GetParam(), paper_law()));
  expect_around(run.forces.at(0), 0.1, 0.05);
}

TEST_P(Shear, ADiskThatCannotRollSlidesAtTheFriction) {
  const SearchEnd run = searched(lying_disk(GetParam(), {.friction = 0.3, .rolling_friction = 1}));
  expect_around(run.forces.at(0), 0.3, 0.05);
}

TEST_P(Shear, DisplacementsArePastThePeriodicSides) {
  Scenario scene = lying_disk(GetParam(), paper_law());
  scene.box = {.width = 4, .height = 4, .sides = Sides::periodic, .floor = true};
  auto& shear = std::get<ShearPhase>(scene.phases[0].kind);
  shear.distance = 10;
  shear.trials.max_time = 1000;
  const CriticalForce found = searched(scene).forces.at(0);
  expect_around(found, 0.1, 0.05);
  EXPECT_EQ(found.undecided, 0);
}

// Five disks in a row on the floor, far apart, and one higher.
Scenario row_of_disks(Method method) {
  Scenario scene = column(method, 0, paper_law());
  for (int k = 0; k < 5; ++k) scene.disks.push_back({.position = {5.0 * k, 0.5}});
  scene.disks.push_back({.position = {30, 3.5}, .fixed = true});
  ShearPhase shear{.depths = {1, 3.5}, .grains_per_depth = 3, .distance = 1};
  shear.trials = {.first_force = 0.4, .tolerance = 0.5};
  scene.phases = {{shear, 1e-2}};
  return scene;
}

TEST_P(Shear, GrainsAreDrawnWithoutRepetitionByTheSeed) {
  std::set<std::vector<int>> draws;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    Scenario scene = row_of_disks(GetParam());
    scene.seed = seed;
    std::vector<int> bodies;
    for (const CriticalForce& found : searched(scene).forces) {
      bodies.push_back(found.body);
      EXPECT_EQ(found.depth, 3.5) << "there is no movable grain at 1 d";
      EXPECT_EQ(found.weight_above, 1) << "of the fixed one";
    }
    EXPECT_EQ(std::set<int>(bodies.begin(), bodies.end()).size(), 3U);
    draws.insert(bodies);
  }
  EXPECT_GT(draws.size(), 1U);
}

TEST_P(Shear, WhereGrainsAreFewAllAreTaken) {
  Scenario scene = row_of_disks(GetParam());
  std::get<ShearPhase>(scene.phases[0].kind).grains_per_depth = 50;
  EXPECT_EQ(searched(scene).forces.size(), 5U);
}

TEST_P(Shear, ProgressRisesToItsEnd) {
  Scenario scene = row_of_disks(GetParam());
  Protocol protocol(scene, make_world(scene));
  double before = 0;
  while (protocol.advance() == Progress::running) {
    EXPECT_GE(protocol.phase_progress(), before);
    before = protocol.phase_progress();
  }
  EXPECT_GT(before, 0.5);
  EXPECT_EQ(protocol.phase_progress(), 1);
}

}  // namespace
}  // namespace quicksand
