// A thousand steps of each kind of motion with the paper's bonds, at the default tolerance. A step that
// does not converge is repeated in halves; none may be left that halving does not repair, and no bond
// may break in a step that did not converge.
#include <gtest/gtest.h>

#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/world/extent.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

constexpr int kGrains = 330, kFewGrains = 100;
constexpr double kPaperCohesion = 1e4;

Scenario paper_scene() {
  Scenario scene;
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 20, .height = 60, .sides = Sides::periodic, .floor = true};
  scene.grain_law = paper_law(kPaperCohesion);
  return scene;
}

// Makes steps until `steps` or the end of the phases.
struct Sequence {
  Sequence(const Scenario& scene, const World& start, int steps)
      : protocol(scene, start), first(start.step) {
    while (protocol.world().step < first + steps && progress != Progress::finished &&
           progress != Progress::failed)
      progress = protocol.advance();
  }
  void expect_sound(int steps) const {
    EXPECT_NE(progress, Progress::failed) << protocol.failure();
    EXPECT_GE(protocol.world().step - first, steps);
    EXPECT_EQ(protocol.state().unconverged_steps, 0);
    EXPECT_EQ(protocol.state().broken_in_unconverged, 0);
    EXPECT_LE(protocol.state().worst_residual, 1e-6);
    EXPECT_LE(measure(protocol.world()).max_overlap, tolerance::sampled(1e-4));
  }

  Protocol protocol;
  std::int64_t first;  // step number at the start
  Progress progress = Progress::running;
};

Scenario with_phase(const Phase& phase, double width = 20) {
  Scenario scene = paper_scene();
  scene.box.width = width;
  scene.phases = {phase};
  return scene;
}

World deposit(int grains, double width) {
  const Scenario scene =
      with_phase({DepositPhase{.grains = grains, .interval = 3e-2}, 1e-2}, width);
  return Sequence(scene, make_world(scene), 1000000).protocol.world();
}

TEST(ThousandSteps, OfADepositionConverge) {
  const Scenario scene = with_phase({DepositPhase{.grains = 1000, .interval = 3e-2}, 1e-2});
  Sequence run(scene, make_world(scene), 1000);
  run.expect_sound(1000);
  EXPECT_GE(run.protocol.world().disks.size(), kGrains);
  EXPECT_EQ(run.protocol.world().bonds.broken, 0) << "no bond of the paper breaks in a deposition";
}

TEST(ThousandSteps, OfRestConverge) {
  Sequence run(with_phase({SettlePhase{.max_time = 10, .until_rest = false}, 1e-2}),
               deposit(kGrains, 20), 1000);
  run.expect_sound(1000);
  EXPECT_LE(measure(run.protocol.world()).max_speed, 1e-2);
}

TEST(ThousandSteps, SlowOfAPushConverge) {
  Sequence run(with_phase({PushPhase{.force = kPaperCohesion}, 1e-3}), deposit(kGrains, 20), 1000);
  run.expect_sound(1000);
  EXPECT_GT(run.protocol.world().bonds.broken, 100) << "the intruder ploughs";
}

// A wall of ten grain masses per length presses with 0.6 F_c per length, which crushes the branches.
void collapse_under_a_piston(int grains, double width) {
  World world = deposit(grains, width);
  const double top = packing_top(world);
  world.walls.push_back({.point = {0, top},
                         .normal = {0, -1},
                         .mass = 10 * width,
                         .force = 0.6 * kPaperCohesion * width,
                         .role = WallRole::piston});
  world.bonding = false;
  world.bonds.mark_initial();
  const Phase collapse{SettlePhase{.max_time = 5, .until_rest = false}, 5e-3};
  Sequence run(with_phase(collapse, width), world, 1000);
  run.expect_sound(1000);
  EXPECT_LT(packing_top(run.protocol.world()), 0.7 * top);
  EXPECT_LT(measure(run.protocol.world()).remaining_bond_fraction, 0.5);
}

TEST(ThousandSteps, SlowOfASmallCollapseUnderAPistonConverge) {
  collapse_under_a_piston(kFewGrains, 10);
}

TEST(ThousandSteps, SlowOfACollapseUnderAPistonConverge) { collapse_under_a_piston(kGrains, 20); }

}  // namespace
}  // namespace quicksand
