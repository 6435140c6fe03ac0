// A search that is interrupted anywhere goes on to the same bytes.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/base/errors.h"
#include "core/checkpoint/checkpoint.h"
#include "core/measures/critical_force.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/checkpoint_files.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/temporary_folder.h"

namespace quicksand {
namespace {

QUICKSAND_PER_GLOBAL_SOLVER(SearchRestart);

// A pile with an intruder in it.
Scenario small_search(Method method, std::vector<Phase> searches) {
  Scenario scene = small_collapse(method, 4);
  scene.phases.insert(scene.phases.end(), searches.begin(), searches.end());
  return scene;
}

PullPhase quick_pull() {
  return {.trials = {.first_force = 150, .tolerance = 0.3, .rest_time = 0.1, .max_time = 0.5}};
}

PushPhase quick_threshold() {
  return {.force = 50,
          .rest_time = 0.1,
          .max_time = 0.5,
          .threshold = Threshold{.distance = 0.1, .tolerance = 0.3}};
}

PenetratePhase quick_penetration() {
  return {.shape = PlateIntruder{.width = 2, .thickness = 0.4},
          .force = 50,
          .depth = 0.2,
          .rest_time = 0.1,
          .max_time = 0.5,
          .threshold = CriticalDrive{.tolerance = 0.3}};
}

VanePhase quick_vane() {
  return {.shape = VaneIntruder{.radius = 1.2, .thickness = 0.2},
          .depth = 1.5,
          .clear = true,
          .torque = 50,
          .angle = 0.1,
          .rest_time = 0.1,
          .max_time = 0.5,
          .threshold = CriticalDrive{.tolerance = 0.3}};
}

ShearPhase quick_shear() {
  return {.trials = {.first_force = 100, .tolerance = 0.3, .rest_time = 0.1, .max_time = 0.5},
          .depths = {1, 2.5},
          .grains_per_depth = 2,
          .distance = 0.5};
}

DepositPhase quick_adiabatic() {
  return {.grains = 25,
          .interval = 1e-2,
          .adiabatic = Adiabatic{.tolerance = 1e-6, .factor = 3, .max_interval = 0.1}};
}

// Compares the unbroken run with one that is written, read and continued at every `stride`-th step, and
// returns the state of its end.
ProtocolState expect_same_end(const Scenario& scene, int stride) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "state.cbor";
  Protocol unbroken(scene, make_world(scene));
  auto broken = std::make_unique<Protocol>(scene, make_world(scene));
  for (int k = 0;; ++k) {
    if (k % stride == stride - 1) {
      write_checkpoint(file, {broken->world(), broken->state(), "scene"});
      const Checkpoint read = read_checkpoint(file);
      broken = std::make_unique<Protocol>(scene, read.world, read.protocol);
    }
    const Progress here = unbroken.advance(), there = broken->advance();
    EXPECT_EQ(here, there) << "after step " << k;
    EXPECT_EQ(world_hash(unbroken.world()), world_hash(broken->world())) << "after step " << k;
    if (here == Progress::finished || here != there) break;
  }
  const ProtocolState &one = unbroken.state(), &other = broken->state();
  EXPECT_EQ(one.critical_forces, other.critical_forces);
  EXPECT_EQ(one.adiabatic_deposits, other.adiabatic_deposits);
  write_checkpoint(file, {unbroken.world(), one, "scene"});
  const Bytes bytes = read_bytes(file);
  write_checkpoint(file, {broken->world(), other, "scene"});
  EXPECT_EQ(read_bytes(file), bytes);
  return one;
}

TEST_P(SearchRestart, OfAPullGivesTheSameForces) {
  const Scenario scene = small_search(GetParam(), {{quick_pull(), 5e-3}});
  EXPECT_EQ(expect_same_end(scene, 7).critical_forces.size(), 1U);
}

TEST_P(SearchRestart, OfAThresholdGivesTheSameForces) {
  const Scenario scene = small_search(GetParam(), {{quick_threshold(), 5e-3}});
  EXPECT_EQ(expect_same_end(scene, 7).critical_forces.size(), 1U);
}

// Drives bring their own intruder.
TEST_P(SearchRestart, OfADriveGivesTheSameForceOrTorque) {
  Scenario scene = small_search(GetParam(), {});
  std::erase_if(scene.phases,
                [](const Phase& phase) { return std::holds_alternative<PushPhase>(phase.kind); });
  for (const Phase& drive : {Phase{quick_penetration(), 5e-3}, Phase{quick_vane(), 5e-3}}) {
    Scenario driven = scene;
    driven.phases.push_back(drive);
    EXPECT_EQ(expect_same_end(driven, 7).critical_forces.size(), 1U);
  }
}

TEST_P(SearchRestart, OfAShearGivesTheSameGrainsAndForces) {
  const Scenario scene = small_search(GetParam(), {{quick_shear(), 1e-2}});
  EXPECT_EQ(expect_same_end(scene, 11).critical_forces.size(), 4U);
}

TEST_P(SearchRestart, OfAnAdiabaticDepositGivesTheSameSamples) {
  Scenario scene = small_collapse(GetParam());
  scene.phases = {{quick_adiabatic(), 1e-2}};
  EXPECT_EQ(expect_same_end(scene, 7).adiabatic_deposits.size(), 3U);
}

// The phases of a continued run may be others than those that wrote its state.
TEST(ContinuedSearch, AsAnotherKindOfPhaseBeginsAnewFromTheBase) {
  const Scenario before = small_search(Method::automatic, {{quick_shear(), 5e-3}});
  Protocol broken(before, make_world(before));
  while (broken.state().search.bracket.trials < 2) ASSERT_NE(broken.advance(), Progress::finished);
  ASSERT_TRUE(broken.state().search.base);
  for (const Phase& other : {Phase{quick_pull(), 5e-3}, Phase{SettlePhase{.max_time = 0.1}},
                             Phase{quick_adiabatic(), 1e-2}}) {
    Scenario after = before;
    after.phases.back() = other;
    Protocol protocol(after, broken.world(), broken.state());
    EXPECT_EQ(protocol.world().disks.position, broken.state().search.base->disks.position);
    Progress progress = Progress::running;
    while (progress == Progress::running) progress = protocol.advance();
    EXPECT_EQ(progress, Progress::phase_ended);
  }
}

TEST(ContinuedSearch, OfAPhaseThatWasNoneBeginsAnew) {
  const Scenario before = small_search(Method::automatic, {});
  Protocol broken(before, make_world(before));
  while (broken.state().phase < 2 || !broken.state().entered) broken.advance();
  Scenario after = before;
  after.phases.back() = {quick_pull(), 5e-3};
  Protocol protocol(after, broken.world(), broken.state());
  while (protocol.advance() == Progress::running) {
  }
  EXPECT_EQ(protocol.state().critical_forces.size(), 1U);
}

TEST(SearchCheckpoint, OfAnImpossibleSearchIsRefused) {
  const Scenario scene = small_search(Method::automatic, {{quick_shear(), 5e-3}});
  Protocol protocol(scene, make_world(scene));
  while (protocol.state().critical_forces.empty()) protocol.advance();
  const Checkpoint original{protocol.world(), protocol.state(), "{}"};
  const std::vector<void (*)(ProtocolState&)> spoil{
      [](ProtocolState& p) { p.search.base = nullptr; },
      [](ProtocolState& p) { p.search.kind = static_cast<SearchKind>(9); },
      [](ProtocolState& p) { p.search.kind = SearchKind::none; },
      [](ProtocolState& p) { p.search.targets.at(0).body = 1000; },
      [](ProtocolState& p) { p.search.bracket.first = 0; },
      [](ProtocolState& p) { p.search.trial_runs = true, p.search.targets.clear(); },
      [](ProtocolState& p) { p.search.bracket.low = -1; },
      [](ProtocolState& p) { p.critical_forces.at(0).force_low = std::nan(""); },
      [](ProtocolState& p) { p.trial_start = std::nan(""); },
      [](ProtocolState& p) {
        World world = *p.search.base;
        world.disks.radius[0] = -1;
        p.search.base = std::make_shared<const World>(world);
      },
  };
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "state.cbor";
  write_checkpoint(file, original);
  EXPECT_NO_THROW(read_checkpoint(file));
  for (std::size_t k = 0; k < spoil.size(); ++k) {
    Checkpoint spoiled = original;
    spoil[k](spoiled.protocol);
    write_checkpoint(file, spoiled);
    EXPECT_THROW(read_checkpoint(file), InputError) << "case " << k;
  }
}

// Two grains that part break their bond in the first step; the trial waits for what breaks.
TEST(SearchRestartOfADrivenBody, KnowsThatABondBrokeInTheStepBefore) {
  Scenario scene = empty_scene(Method::automatic);
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 30, .height = 10, .sides = Sides::open, .floor = true};
  scene.grain_law = {.cohesion_force = 1};
  scene.initial_bonds = InitialBonds::touching;
  scene.step.dt = 0.01;
  scene.disks = {{.position = {5, 0.5}, .role = DiskRole::intruder},
                 {.position = {12, 0.5}, .velocity = {-1, 0}},
                 {.position = {13, 0.5}, .velocity = {1, 0}}};
  scene.phases = {{PullPhase{
      .trials = {.first_force = 0.5, .rest_time = 0.1, .max_time = 5, .until = RestOf::driven},
      .distance = 1}}};
  Protocol whole(scene, make_world(scene));
  whole.advance();
  ASSERT_GT(whole.world().bonds.broken, 0);
  Protocol resumed(scene, whole.world(), whole.state());
  finish_phase(whole);
  finish_phase(resumed);
  EXPECT_EQ(whole.world().step, resumed.world().step);
  EXPECT_EQ(world_hash(whole.world()), world_hash(resumed.world()));
}

}  // namespace
}  // namespace quicksand
