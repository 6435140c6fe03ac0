// A step that fails at its shortest: from where shorter ones have led, the whole one is tried again.
#include <gtest/gtest.h>

#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"

namespace quicksand {
namespace {

// A heap that settles, with so little work for each solution that about half of such heaps stop.
Scenario settling_heap(std::uint64_t seed) {
  Scenario scene;
  scene.seed = seed;
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 6, .height = 12};
  scene.grain_law = {.friction = 0.5, .rolling_friction = 0.1};
  scene.step.dt = 2e-2;
  scene.step.max_halvings = 3;
  scene.solver = {.tolerance = 1e-8, .max_iterations = 100, .max_factorisations = 9};
  scene.phases = {{DepositPhase{.height = 4, .interval = 2e-2}}, {SettlePhase{.max_time = 3}}};
  return scene;
}

TEST(FailedStep, GoesOnFromWhereShorterOnesHaveLed) {
  for (const std::uint64_t seed : {7U, 11U, 60U}) {
    SCOPED_TRACE(seed);
    const Scenario scene = settling_heap(seed);
    Protocol protocol(scene, make_world(scene));
    std::int64_t most_halved = 0;
    double worst_residual = 0;
    Progress last = Progress::running;
    while (last != Progress::finished && last != Progress::failed) {
      const std::int64_t before = protocol.state().halved_steps;
      last = protocol.advance();
      most_halved = std::max(most_halved, protocol.state().halved_steps - before);
      worst_residual = std::max(worst_residual, protocol.last_step().solve.residual.natural);
    }
    EXPECT_EQ(last, Progress::finished) << protocol.failure();
    EXPECT_LE(protocol.state().worst_residual, scene.solver.tolerance);
    EXPECT_EQ(worst_residual, protocol.state().worst_residual) << "a step tells of all its parts";
    EXPECT_EQ(protocol.state().unconverged_steps, 0);
    EXPECT_GE(most_halved, scene.step.max_halvings) << "no step failed at its shortest";
  }
}

}  // namespace
}  // namespace quicksand
