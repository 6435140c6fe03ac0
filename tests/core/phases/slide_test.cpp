// A piston that slides and shears what it presses on.
#include <gtest/gtest.h>

#include <cmath>

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

QUICKSAND_PER_SOLVER(Slide);

constexpr double kPistonWeight = 2, kPistonForce = 30;
constexpr int kRollers = 3;
constexpr double kOnTop = kPistonWeight + kPistonForce,
                 kBelow = kOnTop + kRollers;  // forces in the contacts

// Grains side by side, apart, between a floor and a piston that slides.
Scenario rollers(Method method, double friction, double rolling_friction,
                 const SlidePhase& slide = {.speed = 0.5, .distance = 0.4}) {
  Scenario scene = empty_scene(method);
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 6, .height = 5, .sides = Sides::periodic, .floor = true};
  scene.grain_law = {.friction = friction, .rolling_friction = rolling_friction};
  for (int k = 0; k < kRollers; ++k) scene.disks.push_back({.position = {1.0 + 2 * k, 0.5}});
  scene.step.dt = 1e-2;
  scene.phases = {{PistonPhase{.mass = kPistonWeight,
                               .force = kPistonForce,
                               .ramp_time = 0,
                               .rest_time = 0.05,
                               .max_time = 1,
                               .remove = false}},
                  {slide}};
  return scene;
}

// A wall of the scene on top of the rollers.
Wall plate(double force) {
  return {.point = {3, 1},
          .normal = {0, -1},
          .mass = kPistonWeight,
          .force = force,
          .role = WallRole::piston};
}

DriveResult slide(Protocol& run) {
  EXPECT_EQ(finish_phase(run), Progress::phase_ended) << run.failure();
  EXPECT_EQ(finish_phase(run), Progress::phase_ended) << run.failure();
  return run.state().drive_results.at(0);
}

DriveResult slide(const Scenario& scene) {
  Protocol run(scene, make_world(scene));
  return slide(run);
}

// The torque of the shear force about the contact with the floor is what rolling friction resists with at both contacts,
// c N r at most each.
TEST_P(Slide, OverGrainsThatRollIsResistedByRollingFrictionAlone) {
  for (const double c : {0.0, 0.1}) {
    const DriveResult found = slide(rollers(GetParam(), 0.5, c));
    EXPECT_NEAR(found.residual.value(), c * (kOnTop + kBelow) / 2, tolerance::solved(kOnTop)) << c;
  }
}

TEST_P(Slide, OverGrainsThatCannotRollIsResistedByFriction) {
  const DriveResult found = slide(rollers(GetParam(), 0.3, 10));
  EXPECT_NEAR(found.residual.value(), 0.3 * kOnTop, tolerance::solved(kOnTop));
  EXPECT_NEAR(found.normal_load.value(), kOnTop, tolerance::rounding(kOnTop));
}

// They roll without slipping at both contacts.
TEST_P(Slide, CarriesRollersAlongAtHalfItsSpeed) {
  const Scenario scene = rollers(GetParam(), 0.5, 0);
  Protocol run(scene, make_world(scene));
  slide(run);
  // Clockwise where the piston goes to the right, at 2 v/d of the centre.
  for (const Vec3& v : run.world().disks.velocity)
    EXPECT_LT(distance(v, Vec3(0.25, 0, -0.5)), tolerance::solved());
}

TEST_P(Slide, EndsAfterItsDistanceAndLeavesThePistonAtRestWhereItPressesOn) {
  Scenario scene = rollers(GetParam(), 0.3, 10);
  scene.phases.push_back({SettlePhase{.max_time = 0.2, .until_rest = false}});
  Protocol run(scene, make_world(scene));
  finish_phase(run);
  const double start = run.world().time;
  finish_phase(run);
  EXPECT_NEAR(run.state().drive_results.at(0).way, 0.4, tolerance::rounding());
  EXPECT_NEAR(run.world().time - start, 0.4 / 0.5, tolerance::rounding());
  ASSERT_EQ(finish_phase(run), Progress::phase_ended);
  const Sample after = measure(run.world());
  EXPECT_NEAR(after.piston_x.value(), 0.4, tolerance::rounding()) << "it has stopped";
  EXPECT_NEAR(after.loads.piston.value(), kOnTop, tolerance::solved(kOnTop));
}

TEST_P(Slide, GoesEitherWay) {
  for (const double speed : {0.5, -0.5}) {
    const Scenario scene = rollers(GetParam(), 0.3, 10, {.speed = speed, .distance = 0.4});
    Protocol run(scene, make_world(scene));
    finish_phase(run);
    run.advance();
    run.advance();
    EXPECT_NEAR(wall_loads(run.world()).piston_shear.value(), std::copysign(0.3 * kOnTop, speed),
                tolerance::solved(kOnTop));
    finish_phase(run);
    EXPECT_NEAR(measure(run.world()).piston_x.value(), std::copysign(0.4, speed),
                tolerance::rounding());
    EXPECT_NEAR(run.state().drive_results.at(0).residual.value(), 0.3 * kOnTop,
                tolerance::solved(kOnTop));
  }
}

TEST_P(Slide, SpeedRisesLinearly) {
  const double ramp = 0.2, speed = 0.5;
  const Scenario scene =
      rollers(GetParam(), 0.5, 0, {.speed = speed, .distance = 0.4, .ramp_time = ramp});
  Protocol run(scene, make_world(scene));
  finish_phase(run);
  const double start = run.world().time;
  while (run.world().time < start + ramp - 1e-9) {
    const double begin = run.world().time - start;
    run.advance();
    EXPECT_NEAR(run.world().walls.back().velocity.x(), speed * begin / ramp, tolerance::rounding());
  }
  finish_phase(run);
  EXPECT_NEAR(run.world().time - start, ramp / 2 + 0.4 / speed, 2 * scene.step.dt);
}

// What the piston is driven with comes back as what friction dissipates.
TEST_P(Slide, WorkIsDissipatedByFriction) {
  const Scenario scene = rollers(GetParam(), 0.3, 10);
  Protocol run(scene, make_world(scene));
  finish_phase(run);
  const double before = run.state().energy_dissipated;
  finish_phase(run);
  const double work = 0.3 * kOnTop * 0.4;
  EXPECT_NEAR(run.state().energy_dissipated - before, work, tolerance::solved(kOnTop));
  EXPECT_NEAR(run.state().drive_results.at(0).mean.value() * 0.4, work, tolerance::solved(kOnTop));
}

// Of a step that is made in parts each counts with its own force.
TEST(SlideInHalvedSteps, DoesTheWorkThatTheBodiesReceive) {
  Scenario scene = small_collapse(Method::automatic);
  scene.gravity.reset();
  scene.step.stop_if_unconverged = true;
  scene.step.max_halvings = 12;
  scene.phases = {{DepositPhase{.grains = 40, .interval = 0}},
                  {PistonPhase{.mass = 30, .force = 2000, .max_time = 2, .remove = false}, 5e-3},
                  {SlidePhase{.speed = 5, .distance = 3}, 2e-2}};
  Protocol run(scene, make_world(scene));
  finish_phase(run);
  ASSERT_EQ(finish_phase(run), Progress::phase_ended) << run.failure();
  const std::int64_t halved = run.state().halved_steps;
  Scenario hasty = scene;  // whose solver gives up early, so that some steps are not solved at once
  hasty.solver.max_factorisations = 12;
  run.change(hasty);
  const double before = run.state().external_work;
  const double height = run.world().walls.back().point.y();
  ASSERT_EQ(finish_phase(run), Progress::phase_ended) << run.failure();
  EXPECT_GT(run.state().halved_steps, halved);
  const double received = run.state().external_work - before;  // with the work of the normal force
  const double pressed = 2000 * (height - run.world().walls.back().point.y());
  const DriveResult& found = run.state().drive_results.at(0);
  EXPECT_NEAR(found.mean.value() * found.way, received - pressed,
              tolerance::solved(std::abs(received) + std::abs(pressed)));
}

// Speed over height times the square root of mass over normal stress.
TEST_P(Slide, TellsItsInertialNumber) {
  const DriveResult found = slide(rollers(GetParam(), 0.3, 10));
  EXPECT_NEAR(found.inertial_number.value(), 0.5 / 1 * std::sqrt(6 / kOnTop), tolerance::solved());
}

// Turned back by hand, it has its whole distance to go from there, and its account is of that alone.
TEST(SlideThatTurnsBack, BeginsAnew) {
  const Scenario scene = rollers(Method::automatic, 0.3, 10);
  Protocol run(scene, make_world(scene));
  finish_phase(run);
  for (int k = 0; k < 40; ++k) ASSERT_EQ(run.advance(), Progress::running);
  Scenario turned = scene;
  std::get<SlidePhase>(turned.phases[1].kind).speed = -0.5;
  run.change(turned);
  ASSERT_EQ(finish_phase(run), Progress::phase_ended);
  const DriveResult& found = run.state().drive_results.at(0);
  EXPECT_NEAR(measure(run.world()).piston_x.value(), 0.2 - 0.4, tolerance::rounding());
  EXPECT_NEAR(found.way, 0.4, tolerance::rounding());
  EXPECT_NEAR(found.mean.value(), 0.3 * kOnTop, tolerance::solved(kOnTop));
}

// A wall of the scene that presses from above is a piston, too.
TEST(SlidingWall, MayBeOneOfTheScene) {
  Scenario scene = rollers(Method::automatic, 0.3, 10);
  scene.phases.erase(scene.phases.begin());
  scene.walls = {plate(kPistonForce)};
  ASSERT_NO_THROW(validate(scene));
  Protocol run(scene, make_world(scene));
  finish_phase(run);
  EXPECT_NEAR(run.state().drive_results.at(0).residual.value(), 0.3 * kOnTop,
              tolerance::solved(kOnTop));
  EXPECT_NEAR(run.state().drive_results.at(0).way, 0.4, tolerance::rounding());
}

TEST(Validation, RefusesASlideWithoutAPistonThatStays) {
  const Scenario scene = rollers(Method::automatic, 0.3, 0);
  EXPECT_NO_THROW(validate(scene));
  Scenario removed = scene;
  std::get<PistonPhase>(removed.phases[0].kind).remove = true;
  Scenario resting = scene;
  std::get<SlidePhase>(resting.phases[1].kind).speed = 0;
  Scenario slow = scene;
  std::get<SlidePhase>(slow.phases[1].kind).speed = 1e-300;
  Scenario hasty = scene;
  std::get<SlidePhase>(hasty.phases[1].kind).speed = 100;  // 1 d in a step
  Scenario taken = scene;  // by a second piston phase, which removes it
  taken.phases.insert(taken.phases.begin() + 1, {PistonPhase{}});
  Scenario late = scene;
  std::swap(late.phases[0], late.phases[1]);
  for (const Scenario& spoilt : {removed, resting, slow, hasty, late, taken})
    EXPECT_THROW(validate(spoilt), InputError);
  // Whoever takes it away by hand is told so when the phase begins.
  World world = make_world(removed);
  Protocol run(removed, world);
  finish_phase(run);
  EXPECT_THROW(run.advance(), InputError);
}

TEST(SlidingWall, RefusesAPistonThatPullsAwayWhenItBegins) {
  Scenario scene = rollers(Method::automatic, 0.3, 0);
  scene.phases.erase(scene.phases.begin());
  scene.walls = {plate(-3 * kPistonWeight)};
  Protocol run(scene, make_world(scene));
  EXPECT_THROW(run.advance(), InputError);
}

}  // namespace
}  // namespace quicksand
