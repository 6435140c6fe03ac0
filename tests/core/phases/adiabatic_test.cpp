// The phase "deposit", adiabatic.
#include <gtest/gtest.h>

#include <cmath>

#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_GLOBAL_SOLVER(AdiabaticDeposition);

Scenario deposition(Method method, const Adiabatic& adiabatic) {
  Scenario scene = small_collapse(method);
  scene.phases = {{DepositPhase{.grains = 30, .interval = 1e-2, .adiabatic = adiabatic}, 1e-2}};
  return scene;
}

TEST_P(AdiabaticDeposition, EndsAtItsLongestInterval) {
  const Scenario scene =
      deposition(GetParam(), {.tolerance = 1e-12, .factor = 2, .max_interval = 0.08});
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() != Progress::finished) {
  }
  const auto& samples = protocol.state().adiabatic_deposits;
  ASSERT_EQ(samples.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(samples[k].interval, std::ldexp(1e-2, static_cast<int>(k)));
    EXPECT_EQ(samples[k].grains, 30);
    EXPECT_EQ(samples[k].change.has_value(), k > 0);
  }
  EXPECT_NEAR(protocol.world().time, 30 * 0.15, tolerance::rounding(10));
}

TEST_P(AdiabaticDeposition, EndsWhereTheVolumeFractionNoLongerChanges) {
  const Scenario scene =
      deposition(GetParam(), {.tolerance = 0.05, .factor = 2, .max_interval = 10});
  Protocol protocol(scene, make_world(scene));
  double before = 0;
  while (protocol.advance() == Progress::running) {
    EXPECT_GE(protocol.phase_progress(), before) << "progress rises over all samples";
    before = protocol.phase_progress();
  }
  const auto& samples = protocol.state().adiabatic_deposits;
  ASSERT_GE(samples.size(), 2U);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double change = samples[k].volume_fraction / samples[k - 1].volume_fraction - 1;
    EXPECT_NEAR(*samples[k].change, change, tolerance::rounding());
    EXPECT_EQ(std::abs(change) < 0.05, k + 1 == samples.size());
  }
}

// Samples differ by their interval alone, and the last one stays.
TEST_P(AdiabaticDeposition, LeavesTheSampleThatItsLastIntervalGivesAlone) {
  const Scenario scene =
      deposition(GetParam(), {.tolerance = 1e-12, .factor = 4, .max_interval = 0.04});
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() != Progress::finished) {
  }
  Scenario plain = scene;
  plain.phases = {{DepositPhase{.grains = 30, .interval = 0.04}, 1e-2}};
  Protocol alone(plain, make_world(plain));
  while (alone.advance() != Progress::finished) {
  }
  ASSERT_EQ(protocol.state().adiabatic_deposits.size(), 2U);
  EXPECT_NEAR(protocol.state().adiabatic_deposits[1].volume_fraction,
              measure(alone.world()).volume_fraction.value(), tolerance::solved());
  ASSERT_EQ(protocol.world().disks.size(), 30);
  for (int i = 0; i < 30; ++i)
    EXPECT_LT(distance(protocol.world().disks.position[i], alone.world().disks.position[i]),
              tolerance::solved())
        << i;
}

}  // namespace
}  // namespace quicksand
