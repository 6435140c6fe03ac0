// Release and debug, GCC and Clang: as long as a build computes in IEEE doubles and neither contracts nor
// reorders (-ffp-contract=off, no -ffast-math), a run has the same bytes. A change of the physics changes the
// number below; a change of the compiler must not.
#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/world/ballistic.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"

namespace quicksand {
namespace {

TEST(WorldHash, OfACollapseIsTheSameInEveryBuild) {
  const Scenario scene = small_collapse(Method::automatic);
  Protocol run(scene, make_world(scene));
  Progress made = Progress::running;
  while (made != Progress::finished) {
    made = run.advance();
    ASSERT_NE(made, Progress::failed);
  }
  EXPECT_EQ(world_hash(run.world()), 0x868D44481B0AC35BULL) << std::hex << world_hash(run.world());
}

// A loose network that begins to fall, large enough that its loops are shared and its factorisation has
// subtrees.
TEST(WorldHash, IsTheSameForAnyNumberOfThreads) {
  Scenario soil = empty_scene(Method::interior_point);
  soil.box = {.width = 40, .height = 200, .sides = Sides::periodic, .floor = true};
  soil.gravity = Vec2(0, -1);
  soil.grain_law = paper_law(300);
  soil.wall_law = paper_law(300);
  soil.initial_bonds = InitialBonds::touching;
  soil.solver.tolerance = 1e-6;
  World deposit = make_world(soil);
  for (int k = 0; k < 3200; ++k) {
    const Vec2 place = LandingSite(deposit).land(40 * deposit.random.uniform(), 0.5)->centre;
    deposit.disks.add({.position = place});
    soil.disks.push_back({.position = place});
  }
  const auto hash = [&](int threads) {
    Simulation run(soil);
    with_threads(threads, [&] { run.advance(3); });
    EXPECT_EQ(run.unconverged, 0);
    EXPECT_EQ(run.last.solve.stage, SolverStage::interior_point);
    return world_hash(run.world);
  };
  const std::uint64_t alone = hash(1);
  EXPECT_EQ(hash(2), alone);
  EXPECT_EQ(hash(3), alone);
}

}  // namespace
}  // namespace quicksand
