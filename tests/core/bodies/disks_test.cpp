#include "core/bodies/disks.h"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

TEST(Disks, AGrainHasUnitMassAndTheInertiaOfADisk) {
  Disks disks;
  const int i = disks.add({});
  EXPECT_EQ(disks.mass[i], 1);
  EXPECT_EQ(disks.inertia(i), 0.125);
  EXPECT_EQ(disks.inverse_mass[i], Vec3(1, 1, 8));
}

TEST(Disks, MassGrowsWithDensityAndArea) {
  Disks disks;
  const int i = disks.add({.radius = 1.5, .density = 0.5});
  EXPECT_EQ(disks.mass[i], 4.5);
  EXPECT_EQ(disks.inertia(i), 4.5 * 1.5 * 1.5 / 2);
}

TEST(Disks, AFixedDiskDoesNotRespondButKeepsItsMassAndVelocity) {
  Disks disks;
  const int i = disks.add({.velocity = {1, 2}, .spin = 3, .fixed = true});
  EXPECT_TRUE(disks.fixed(i));
  EXPECT_EQ(disks.inverse_mass[i], Vec3(0, 0, 0));
  EXPECT_EQ(disks.mass[i], 1);
  EXPECT_EQ(disks.velocity[i], Vec3(1, 2, 3));
}

TEST(Disks, EveryArrayGrowsByOne) {
  Disks disks;
  EXPECT_EQ(disks.add({}), 0);
  EXPECT_EQ(disks.add({.role = DiskRole::intruder}), 1);
  for (std::size_t size :
       {disks.position.size(), disks.angle.size(), disks.velocity.size(), disks.applied.size(),
        disks.radius.size(), disks.mass.size(), disks.inverse_mass.size(), disks.role.size()})
    EXPECT_EQ(size, 2U);
}

}  // namespace
}  // namespace quicksand
