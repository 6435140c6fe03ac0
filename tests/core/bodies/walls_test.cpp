#include "core/bodies/walls.h"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

TEST(Walls, AWallWithoutMassDoesNotRespond) { EXPECT_EQ(Wall{}.inverse_mass(), Vec3(0, 0, 0)); }

TEST(Walls, AWallWithMassRespondsAlongItsNormalOnlyAndNeverTurns) {
  EXPECT_EQ((Wall{.normal = {0, -1}, .mass = 4}.inverse_mass()), Vec3(0, 0.25, 0));
  EXPECT_EQ((Wall{.normal = {-1, 0}, .mass = 4}.inverse_mass()), Vec3(0.25, 0, 0));
}

}  // namespace
}  // namespace quicksand
