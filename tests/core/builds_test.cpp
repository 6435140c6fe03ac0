// Release and debug, GCC and Clang: as long as a build computes in IEEE doubles and neither contracts nor
// reorders (-ffp-contract=off, no -ffast-math), a run has the same bytes. A change of the physics changes the
// number below; a change of the compiler must not.
#include <gtest/gtest.h>

#include "core/protocols.h"
#include "tests/support/core/scenes.h"

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
  EXPECT_EQ(world_hash(run.world()), 0x5A1CB1F07E59DCA3ULL) << std::hex << world_hash(run.world());
}

}  // namespace
}  // namespace quicksand
