// The energy of an unforced system never grows, and what is worked from outside is counted.
#include "core/step/energy_balance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Energy);

TEST_P(Energy, OfAnUnforcedSystemNeverGrows) {
  Scenario scene = small_collapse(GetParam());
  scene.gravity.reset();
  // Thirty grains fly at each other and stick, bonds break and hold.
  scene.phases = {{DepositPhase{.grains = 30, .interval = 0.02, .drop_velocity = 3}},
                  {SettlePhase{.max_time = 1, .until_rest = false}}};
  Protocol protocol(scene, make_world(scene));
  while (protocol.phase() && std::holds_alternative<DepositPhase>(protocol.phase()->kind))
    protocol.advance();
  const ProtocolState before = protocol.state();
  const auto moving = [&] {
    const Energies e = energies(protocol.world());
    return e.kinetic + e.rotational;
  };
  const double begin = moving();
  while (protocol.advance() == Progress::running) {
  }
  const ProtocolState& after = protocol.state();
  EXPECT_EQ(after.external_work, before.external_work);
  EXPECT_LT(moving(), begin);
  EXPECT_NEAR(after.energy_gained - before.energy_gained, 0, 1e-3 * begin);
  EXPECT_NEAR(after.energy_dissipated - before.energy_dissipated, begin - moving(), 1e-2 * begin);
}

// What dissipation and gain leave is what the pair still has, in its motion and in the gap of its bond.
TEST_P(Energy, OfABondedPairThatSpinsIsAccountedForWhateverItTurnsInAStep) {
  constexpr double kSpin = 10, kCohesion = 1e4;
  for (const double dt : {1e-2, 2e-2}) {
    Scenario scene = spinning_pair(GetParam(), kSpin, kCohesion);
    scene.step.dt = dt;
    scene.phases = {{SettlePhase{.max_time = 2, .until_rest = false}}};
    Protocol protocol(scene, make_world(scene));
    while (protocol.advance() == Progress::running) {
    }
    const World& world = protocol.world();
    const Energies end = energies(world);
    const double begin = kSpin * kSpin * (1.0 / 4 + 1.0 / 8);
    const double left = end.kinetic + end.rotational + kCohesion * world.gap({0, 1});
    const ProtocolState& state = protocol.state();
    EXPECT_NEAR(state.energy_dissipated - state.energy_gained, begin - left, 1e-6 * begin);
    const double turn = kSpin * dt;
    const double to_begin = begin * turn * turn / 6 + kCohesion * std::pow(turn, 4) / 8;
    EXPECT_LT(state.energy_gained, 2 * to_begin);
    EXPECT_LT(state.energy_dissipated, 2 * to_begin);
  }
}

// Two disks that pass each other bond at their touch, which leaves the bond a gap; the next step closes it.
TEST_P(Energy, OfABondThatFormsIsAccountedForWithItsGap) {
  constexpr double kCohesion = 1e4;
  Scenario scene = spinning_pair(GetParam(), 0, kCohesion);
  scene.initial_bonds = InitialBonds::none;
  scene.disks = {{.position = {0, 0}, .velocity = {1, 0}},
                 {.position = {1.2, 0.6}, .velocity = {-1, 0}}};
  scene.phases = {{SettlePhase{.max_time = 0.6, .until_rest = false, .bonding = true}}};
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() == Progress::running) {
  }
  const World& world = protocol.world();
  ASSERT_EQ(world.bonds.list.size(), 1u);
  const Energies end = energies(world);
  const double begin = 2 * 1.0 / 2;
  const double left = end.kinetic + end.rotational + kCohesion * world.gap({0, 1});
  const ProtocolState& state = protocol.state();
  EXPECT_NEAR(state.energy_dissipated - state.energy_gained, begin - left, 1e-6);
}

TEST_P(Energy, OfAFreeFallIsTheWorkOfGravity) {
  Scenario scene;
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 0, .height = 10, .sides = Sides::open, .floor = false};
  scene.solver.method = GetParam();
  scene.disks = {{.position = {0, 5}}};
  scene.phases = {{SettlePhase{.max_time = 1, .until_rest = false}}};
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() == Progress::running) {
  }
  const double fallen = 5 - protocol.world().disks.position[0].y();
  EXPECT_NEAR(protocol.state().external_work, fallen, 1e-12);
  // Implicit Euler takes dt^2/2 of it a step.
  EXPECT_NEAR(protocol.state().energy_dissipated, 100 * 1e-4 / 2, 1e-12);
  EXPECT_EQ(protocol.state().energy_gained, 0);
}

// What pushes a disk along as prescribed works on it: from rest to the wall's velocity in one step.
TEST_P(Energy, IncludesTheWorkOfPrescribedMotion) {
  Scenario scene;
  scene.box = {.width = 0, .height = 10, .sides = Sides::open, .floor = false};
  scene.solver.method = GetParam();
  scene.disks = {{.position = {0, 0.5}}};
  scene.walls = {{.point = {0, 0}, .normal = {0, 1}, .velocity = {0, 2}}};
  scene.phases = {{SettlePhase{.max_time = 0.1, .until_rest = false}}};
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() == Progress::running) {
  }
  EXPECT_NEAR(protocol.state().external_work, 4, 1e-4);
  EXPECT_NEAR(protocol.state().energy_dissipated, 2, 1e-4);
  EXPECT_NEAR(protocol.state().energy_gained, 0, 1e-4);
}

// A belt, which has a mass across itself, drags a disk along: its drive works against the friction.
TEST_P(Energy, IncludesTheWorkOfAWallThatGlidesAlongItself) {
  double dissipated[2];
  for (const bool heavy : {false, true}) {
    Scenario scene;
    scene.box = {.width = 0, .height = 10, .sides = Sides::open, .floor = false};
    scene.solver.method = GetParam();
    scene.gravity = Vec2(0, -1);
    scene.grain_law.friction = 0.3;
    scene.disks = {{.position = {0, 0.5}}};
    // Carried by a force that balances both weights.
    scene.walls = {{.velocity = {2, 0}, .mass = heavy ? 3.0 : 0, .force = heavy ? 4.0 : 0}};
    scene.phases = {{SettlePhase{.max_time = 0.5, .until_rest = false}}};
    Protocol protocol(scene, make_world(scene));
    while (protocol.advance() == Progress::running) {
    }
    EXPECT_NEAR(protocol.state().external_work, 0.3 * 2 * 0.5, 1e-9) << heavy;
    EXPECT_NEAR(protocol.state().energy_gained, 0, 1e-9) << heavy;
    dissipated[heavy ? 1 : 0] = protocol.state().energy_dissipated;
  }
  EXPECT_NEAR(dissipated[0], dissipated[1], 1e-9);
}

// Overlaps that are pushed apart give energy: that is what `energy_gained` is there to show.
TEST_P(Energy, ThatOverlapsBringIsSeen) {
  Scenario scene;
  scene.box = {.width = 0, .height = 10, .sides = Sides::open, .floor = false};
  scene.solver.method = GetParam();
  scene.disks = {{.position = {0, 0}}, {.position = {1, 0}}};
  scene.phases = {{SettlePhase{.max_time = 0.1, .until_rest = false}}};
  World world = make_world(scene);
  world.disks.position[1].x() -= 0.01;
  Protocol protocol(scene, world);
  while (protocol.advance() == Progress::running) {
  }
  EXPECT_GT(protocol.state().energy_gained, 0.1);
  EXPECT_NEAR(protocol.state().worst_overlap, 0.01, 1e-12);
}

}  // namespace
}  // namespace quicksand
