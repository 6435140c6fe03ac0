// A piston that presses from above.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/base/errors.h"
#include "core/forces/wall_loads.h"
#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Piston);

constexpr int kGrains = 4;
constexpr double kMass = 3, kForce = 20, kRamp = 0.2, kTimeStep = 1e-2;
const PistonPhase kPiston{
    .mass = kMass, .force = kForce, .ramp_time = kRamp, .rest_time = 0.1, .max_time = 5};

// A column of grains in a box, under a piston.
Scenario pressed_column(Method method, const PistonPhase& piston, double cohesion = 0) {
  Scenario scene = column(method, kGrains, paper_law(cohesion));
  scene.box = {.width = 5, .height = 5, .sides = Sides::walls, .floor = true};
  for (Disk& disk : scene.disks) disk.position.x() = 2.5;
  scene.step.dt = kTimeStep;
  scene.phases = {{piston}};
  return scene;
}

struct PhaseRun {
  explicit PhaseRun(const Scenario& scenario) : protocol(scenario, make_world(scenario)) {}
  PhaseRun& to_end_of_phase() {
    while (protocol.advance() == Progress::running) {
    }
    return *this;
  }
  const World& world() const { return protocol.world(); }
  // Upward force of the last step on the last wall [F_g].
  double load() const {
    return contact_force_on(world(), wall_body(static_cast<int>(world().walls.size()) - 1)).y();
  }
  Protocol protocol;
};

PistonPhase staying(PistonPhase piston = kPiston) {
  piston.remove = false;
  return piston;
}

// Forces are judged relative to those of all that moves, the piston's weight included.
TEST(HeavyPiston, OnAColumnNeedsNoShorterSteps) {
  for (const double mass : {1e4, 1e6, 1e8}) {
    PistonPhase heavy = staying();
    heavy.mass = mass;
    heavy.force = 0;
    PhaseRun run(pressed_column(Method::automatic, heavy));
    run.to_end_of_phase();
    EXPECT_EQ(run.protocol.state().halved_steps, 0) << mass;
    EXPECT_NEAR(run.load() / (mass + kGrains), 1, 5e-3) << mass;
  }
}

// Wherever the floor is.
TEST_P(Piston, EndsWhereTheDisksFillTheShareOfTheRoomBetweenFloorAndPiston) {
  PistonPhase falling = staying();
  falling.volume_fraction = 0.126;  // four disks of pi/4 in 5 x 5 fill it
  for (const double floor : {0.0, 7.0}) {
    Scenario scene = pressed_column(GetParam(), falling);
    if (floor > 0) scene.walls = {{.point = {0, floor}}};
    scene.disks.resize(4);
    for (std::size_t i = 0; i < 4; ++i)
      scene.disks[i].position = {1.0 + static_cast<double>(i), floor + (i == 0 ? 5.0 : 0.5)};
    scene.phases[0].dt = 1e-3;
    PhaseRun run(scene);
    run.to_end_of_phase();
    const double height = run.world().walls.back().point.y() - floor;
    EXPECT_LE(height, std::numbers::pi / (5 * 0.126)) << floor;
    EXPECT_GT(height, 0.99 * std::numbers::pi / (5 * 0.126)) << floor;
  }
}

TEST_P(Piston, PassesItsForceAndAllWeightsOnToTheFloor) {
  PhaseRun run(pressed_column(GetParam(), staying()));
  run.to_end_of_phase();
  EXPECT_NEAR(run.load(), kMass + kForce, tolerance::solved(kForce));
  EXPECT_NEAR(wall_loads(run.world()).piston.value(), kMass + kForce, tolerance::solved(kForce));
  for (int k = 1; k < kGrains; ++k)
    EXPECT_NEAR(contact_force(run.world(), {k - 1, k}).y(), kMass + kForce + kGrains - k,
                tolerance::solved(kForce));
  EXPECT_NEAR(contact_force_on(run.world(), wall_body(0)).y(), -(kMass + kForce + kGrains),
              tolerance::solved(kForce));
}

TEST_P(Piston, ForceRisesLinearlyFromZero) {
  PhaseRun run(pressed_column(GetParam(), kPiston));
  const int steps = static_cast<int>(std::lround(kRamp / kTimeStep));
  for (int k = 0; k < steps + 5; ++k) {
    ASSERT_EQ(run.protocol.advance(), Progress::running);
    const double share = std::min(1.0, static_cast<double>(k) / steps);
    EXPECT_NEAR(run.load(), kMass + share * kForce, tolerance::solved(kForce)) << "step " << k;
  }
}

TEST_P(Piston, WithoutForcePressesWithItsWeightOnly) {
  PistonPhase piston = staying();
  piston.force = 0;
  PhaseRun run(pressed_column(GetParam(), piston));
  EXPECT_NEAR(run.to_end_of_phase().load(), kMass, tolerance::solved());
}

TEST_P(Piston, WithoutRampPressesAtOnce) {
  PistonPhase piston = kPiston;
  piston.ramp_time = 0;
  PhaseRun run(pressed_column(GetParam(), piston));
  run.protocol.advance();
  EXPECT_NEAR(run.load(), kMass + kForce, tolerance::solved(kForce));
}

TEST_P(Piston, EndsAtRestAfterTheRampOrAtTheLongestTime) {
  EXPECT_NEAR(PhaseRun(pressed_column(GetParam(), kPiston)).to_end_of_phase().world().time,
              kRamp + kPiston.rest_time, tolerance::rounding());
  PistonPhase hasty = kPiston;
  hasty.max_time = 0.25;
  EXPECT_NEAR(PhaseRun(pressed_column(GetParam(), hasty)).to_end_of_phase().world().time, 0.25,
              tolerance::rounding());
}

// A grain that rolls along does not keep a phase from ending that waits for the piston alone.
TEST_P(Piston, EndsAtItsOwnRestIfTheSceneSaysSo) {
  for (const RestOf until : {RestOf::driven, RestOf::all}) {
    PistonPhase piston = kPiston;
    piston.until = until;
    piston.max_time = 1;
    Scenario scene = pressed_column(GetParam(), piston);
    scene.disks.push_back({.position = {0.6, 0.5}, .velocity = {0.9, 0}});
    EXPECT_NEAR(PhaseRun(scene).to_end_of_phase().world().time,
                until == RestOf::driven ? kRamp + kPiston.rest_time : 1, tolerance::rounding());
  }
}

TEST_P(Piston, LeavesNothingBehindWhenItIsTakenAway) {
  PistonPhase sticky = kPiston;
  sticky.bonding = true;
  PhaseRun run(pressed_column(GetParam(), sticky, 50));
  run.protocol.advance();
  const Pair pair{kGrains - 1, wall_body(3)};
  ASSERT_TRUE(run.world().bonds.find(pair)) << "first touch";
  run.to_end_of_phase();
  EXPECT_EQ(run.world().walls.size(), 3U);
  EXPECT_FALSE(run.world().bonds.find(pair));
  EXPECT_EQ(run.world().bonds.list.size(), 4U) << "those of the grains stay";
  EXPECT_TRUE(std::ranges::none_of(run.world().contacts,
                                   [&](const Contact& c) { return c.pair.b == pair.b; }));
}

TEST_P(Piston, ThatIsTakenAwayLeavesTheGrainsToTheirWeight) {
  Scenario scene = pressed_column(GetParam(), kPiston);
  scene.phases.push_back({SettlePhase{.max_time = 0.1, .until_rest = false}});
  PhaseRun run(scene);
  run.to_end_of_phase().to_end_of_phase();
  EXPECT_NEAR(contact_force_on(run.world(), wall_body(0)).y(), -kGrains, tolerance::solved());
}

TEST_P(Piston, ThatStaysPressesOn) {
  Scenario scene = pressed_column(GetParam(), staying());
  scene.phases.push_back({SettlePhase{.max_time = 0.1, .until_rest = false}});
  PhaseRun run(scene);
  run.to_end_of_phase().to_end_of_phase();
  EXPECT_NEAR(run.load(), kMass + kForce, tolerance::solved(kForce));
  EXPECT_NEAR(*measure(run.world()).piston_y, kGrains, tolerance::solved());
}

// As in a staged test: the next load goes onto the plate that stands.
TEST_P(Piston, OfASecondPhaseIsTheOneThatStandsLoadedAnew) {
  Scenario scene = pressed_column(GetParam(), staying());
  PistonPhase heavier = staying();
  heavier.mass = kMass + 1;
  heavier.force = 3 * kForce;
  scene.phases.push_back({heavier});
  PhaseRun run(scene);
  run.to_end_of_phase();
  const std::size_t walls = run.world().walls.size();
  const double start = run.world().time;
  ASSERT_EQ(run.protocol.advance(), Progress::running);
  ASSERT_EQ(run.protocol.advance(), Progress::running);
  EXPECT_NEAR(run.load(), kMass + 1 + kForce * (1 + 2 * kTimeStep / kRamp),
              tolerance::solved(kForce))
      << "from the force that it had";
  run.to_end_of_phase();
  EXPECT_EQ(run.world().walls.size(), walls);
  EXPECT_NEAR(run.load(), kMass + 1 + 3 * kForce, tolerance::solved(kForce));
  EXPECT_NEAR(run.world().time - start, kRamp + kPiston.rest_time, 2 * kTimeStep);
}

TEST(PistonPlace, IsTheTopOfAllBodiesIntrudersIncluded) {
  Scenario scene = pressed_column(Method::automatic, kPiston);
  scene.disks.push_back({.position = {1, 4.5}, .radius = 0.7, .role = DiskRole::intruder});
  PhaseRun run(scene);
  EXPECT_FALSE(measure(run.world()).piston_y);
  run.protocol.advance();
  EXPECT_GE(*measure(run.world()).piston_y, 5.2 - kTimeStep) << "a step's way below at most";
  EXPECT_GE(run.world().gap({kGrains, wall_body(3)}), -1e-9);
}

TEST(PistonMarks, InitialBondsOnlyIfNoneAreMarked) {
  Scenario scene = pressed_column(Method::automatic, kPiston, 50);
  World world = make_world(scene);
  world.bonds.form({{0, 1}, {1, 2}});
  {
    Protocol fresh(scene, world);
    fresh.advance();
    EXPECT_EQ(fresh.world().bonds.initial, 2);
  }
  world.bonds.mark_initial();
  world.bonds.form({{2, 3}});
  Protocol marked(scene, world);
  marked.advance();
  EXPECT_EQ(marked.world().bonds.initial, 2);
  EXPECT_FALSE(marked.world().bonds.find({2, 3})->initial);
}

TEST(SlowPistonCollapse, MakesALoosePackingDenser) {
  Scenario scene = small_collapse(Method::automatic);
  scene.phases = {{DepositPhase{.grains = 60, .interval = 0}},
                  {PistonPhase{.mass = 50, .force = 5000, .max_time = 20}, 5e-3}};
  PhaseRun run(scene);
  const Sample before = measure(run.to_end_of_phase().world());
  const Sample after = measure(run.to_end_of_phase().world());
  EXPECT_LT(after.time, 20) << "it comes to rest";
  EXPECT_LT(after.packing_top, 0.7 * before.packing_top);
  EXPECT_GT(after.volume_fraction.value(), 1.5 * before.volume_fraction.value());
  EXPECT_LT(after.remaining_bond_fraction, 0.5);
}

// Nothing but the piston loads the disks: its force is what errors are measured by.
TEST(Piston, PressesWithoutGravity) {
  for (const double force : {1.0, 1e6}) {
    Scenario scene = empty_scene(Method::automatic);
    scene.box = {.width = 4, .height = 10, .sides = Sides::walls, .floor = true};
    scene.grain_law = {.friction = 0.3, .rolling_friction = 0.1};
    for (int row = 0; row < 3; ++row)
      for (int k = 0; k < 4; ++k) scene.disks.push_back({.position = {0.5 + k, 0.5 + row}});
    scene.phases = {{PistonPhase{.force = force, .ramp_time = 0, .max_time = 0.2}}};
    Protocol protocol(scene, make_world(scene));
    ASSERT_EQ(finish_phase(protocol), Progress::phase_ended) << protocol.failure();
    EXPECT_EQ(protocol.state().halved_steps, 0) << force;
    EXPECT_EQ(protocol.state().unconverged_steps, 0) << force;
  }
}

TEST(Validation, RefusesAPistonWithoutFloorSidesOrBodies) {
  Scenario scene = pressed_column(Method::automatic, kPiston);
  EXPECT_NO_THROW(validate(scene));
  for (const auto spoil :
       {+[](Scenario& s) { s.box.floor = false; }, +[](Scenario& s) { s.box.sides = Sides::open; },
        +[](Scenario& s) { s.disks.clear(); }}) {
    Scenario spoilt = scene;
    spoil(spoilt);
    EXPECT_THROW(validate(spoilt), InputError);
  }
  scene.disks.clear();
  scene.phases.insert(scene.phases.begin(), {DepositPhase{.grains = 1}});
  EXPECT_NO_THROW(validate(scene));
}

TEST(PistonAtAVolumeFraction, HasMissedNoRest) {
  PistonPhase piston = kPiston;
  piston.volume_fraction = 0.14;
  Scenario scene = pressed_column(Method::automatic, piston);
  scene.disks[2].position.x() += 0.1;  // so that the column gives way
  scene.disks[3].position.x() -= 0.1;
  Protocol run(scene, make_world(scene));
  ASSERT_EQ(finish_phase(run), Progress::phase_ended);
  ASSERT_LT(run.world().time, piston.max_time) << "it ended at its volume fraction";
  EXPECT_FALSE(run.missed_rest());
}

}  // namespace
}  // namespace quicksand
