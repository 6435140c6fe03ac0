// What a driven intruder is said to have met.
#include <gtest/gtest.h>

#include "core/forces/reaction.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

// A grain in the air is struck at 1 sqrt(g d) by an intruder of infinite mass, long before the way ends. Its load is
// an impulse over dt, of which means over the way say the same at any step, wherever the way begins and ends.
TEST(LoadOfADrive, HasAPeakThatDoesNotDependOnWhereTheWayBeginsAndEnds) {
  const auto peak = [](double surface, bool late = false) {
    Scenario scene = empty_scene(Method::automatic);
    scene.box = {.width = 30, .height = 10, .sides = Sides::open};
    scene.step.dt = 1e-3;
    scene.disks = {{.position = {10, 3}}};
    if (surface > 3.5) scene.disks.push_back({.position = {2, surface - 0.5}, .fixed = true});
    // Strikes the first grain and with it the intruder 0.03 d before the way ends.
    if (late) scene.disks.push_back({.position = {10, 0.75}, .velocity = {0, 4}});
    scene.phases = {{PenetratePhase{.shape = DiskIntruder{.diameter = 1},
                                    .x = 10,
                                    .speed = 1,
                                    .depth = surface - 3.5 + (late ? 0.28 : 0.3),
                                    .max_time = 5}}};
    Protocol run(scene, make_world(scene));
    finish_phase(run);
    return run.state().drive_results.at(0).peak.value();
  };
  const double at_once = peak(3.5);
  EXPECT_LT(at_once, 20);
  EXPECT_NEAR(peak(6), at_once, 0.2 * at_once);
  EXPECT_NEAR(peak(3.5, true), 5 * at_once, at_once) << "in what is left after whole windows";
}

// What presses on fixed grains goes nowhere, and meets a load all the same.
TEST(LoadOfADrive, OfABodyThatDoesNotMoveHasAPeak) {
  Scenario scene = empty_scene(Method::automatic);
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 20, .height = 20, .sides = Sides::periodic, .floor = true};
  for (int k = 0; k < 20; ++k) scene.disks.push_back({.position = {k, 0.5}, .fixed = true});
  scene.phases = {{PenetratePhase{.shape = PlateIntruder{.width = 4, .thickness = 0.5},
                                  .force = 50,
                                  .depth = 1,
                                  .max_time = 5}}};
  Protocol run(scene, make_world(scene));
  finish_phase(run);
  const DriveResult& found = run.state().drive_results.at(0);
  const double resistance = reaction_on(run.world(), run.world().intruder()).force.y();
  EXPECT_GT(resistance, 50);
  EXPECT_GT(found.peak, 0.5 * resistance) << "a mean over the ramp, too";
  EXPECT_LE(found.peak, resistance + tolerance::solved(60));
  EXPECT_EQ(found.residual, std::nullopt) << "the last quarter of its way was never reached";
  EXPECT_EQ(sensitivity(found), std::nullopt);
}

TEST(Sensitivity, IsThatOfARealResidual) {
  EXPECT_EQ(sensitivity({.peak = 6, .residual = 4}), 1.5);
  EXPECT_EQ(sensitivity({.peak = 9, .residual = 7e-15}), std::nullopt);
  EXPECT_EQ(sensitivity({.peak = 9}), std::nullopt);
}

}  // namespace
}  // namespace quicksand
