// States of files that fit together by their checksum and their values, and still lack what a phase has made.
#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "tests/support/core/scenes.h"

namespace quicksand {
namespace {

Scenario with_phase(const Phase& phase) {
  Scenario scene = small_collapse(Method::automatic);
  scene.phases = {{DepositPhase{.grains = 12, .interval = 0}}, phase};
  return scene;
}

struct UnderWay {
  World world;
  ProtocolState state;
};

// As far as the first step of its second phase.
UnderWay under_way(const Scenario& scene) {
  Protocol protocol(scene, make_world(scene));
  while (protocol.world().step == 0) protocol.advance();
  return {protocol.world(), protocol.state()};
}

const std::vector<Phase>& phases_that_make_bodies() {
  static const std::vector<Phase> phases{
      {PushPhase{.force = 10}},
      {PenetratePhase{.speed = 1, .depth = 1}},
      {VanePhase{
          .shape = VaneIntruder{.radius = 1}, .depth = 1, .clear = true, .angular_velocity = 1}},
      {PistonPhase{.mass = 10, .force = 10}}};
  return phases;
}

TEST(StateUnderWay, GoesOnIfItIsWhole) {
  for (const Phase& phase : phases_that_make_bodies()) {
    const Scenario scene = with_phase(phase);
    const auto [world, state] = under_way(scene);
    Protocol after(scene, world, state);
    EXPECT_NO_THROW(after.advance()) << phase_name(phase);
  }
}

TEST(StateUnderWay, IsRefusedWithoutTheIntruderOrThePistonOfItsPhase) {
  for (const Phase& phase : phases_that_make_bodies()) {
    const Scenario scene = with_phase(phase);
    const ProtocolState state = under_way(scene).state;
    World without = make_world(scene);
    without.disks.add({.position = {3, 1}});
    EXPECT_THROW(Protocol(scene, without, state), InputError) << phase_name(phase);
  }
}

TEST(StateUnderWay, IsRefusedWithoutWhatItsPhaseRemembers) {
  for (const Phase& phase : phases_that_make_bodies()) {
    if (std::holds_alternative<PushPhase>(phase.kind) ||
        std::holds_alternative<PistonPhase>(phase.kind))
      continue;  // they go on from the world alone
    const Scenario scene = with_phase(phase);
    UnderWay before = under_way(scene);
    before.state.memory.clear();
    EXPECT_THROW(Protocol(scene, before.world, before.state), InputError) << phase_name(phase);
  }
}

}  // namespace
}  // namespace quicksand
