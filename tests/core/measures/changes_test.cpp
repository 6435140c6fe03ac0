#include "core/measures/changes.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/placing/remove_disks.h"
#include "core/scene/make_world.h"
#include "tests/support/core/scenes.h"

namespace quicksand {
namespace {

TEST(Changes, OfAStateToItselfAreNone) {
  const World world = make_world(bonded_row(5));
  const Changes none = changes_between(world, world);
  EXPECT_EQ(none.grains.size(), 5U);
  EXPECT_EQ(none.duration, 0);
  EXPECT_EQ(none.largest_displacement, 0);
  EXPECT_EQ(none.displaced + none.bonds_broken + none.bonds_formed, 0);
  EXPECT_EQ(none.contacts_lost + none.contacts_gained, 0);
}

// The last disk rolls round the one before it, and a quarter of a turn later lies above it.
TEST(Changes, AreThoseOfTheGrainThatMoved) {
  const World before = make_world(bonded_row(5));
  World now = before;
  now.time = 2;
  now.disks.position[4] = {3.5, 1};
  now.disks.angle[4] = std::numbers::pi / 2;
  now.bonds.find({3, 4})->state = BondState::broken;
  const Changes changes = changes_between(before, now);
  EXPECT_EQ(changes.duration, 2);
  EXPECT_EQ(changes.bonds_broken, 1);
  EXPECT_EQ(changes.bonds_formed, 0);
  EXPECT_EQ(changes.contacts_lost, 0) << "a broken bond may still touch";
  EXPECT_EQ(changes.displaced, 1);
  EXPECT_DOUBLE_EQ(changes.largest_displacement, std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(changes.mean_displacement, std::numbers::sqrt2 / 5);
  EXPECT_DOUBLE_EQ(changes.mean_sinking, -1.0 / 5);
  EXPECT_EQ(changes.grains[4].displacement, Vec2(-1, 1));
  EXPECT_EQ(changes.grains[4].rotation, std::numbers::pi / 2);
  EXPECT_EQ(changes.grains[4].bonds_broken, 1);
  EXPECT_EQ(changes.grains[3].bonds_broken, 1);
  EXPECT_EQ(changes.grains[2].bonds_broken, 0);
  const Changes back = changes_between(now, before);
  EXPECT_EQ(back.bonds_formed, 1);
  EXPECT_EQ(back.bonds_broken, 0);
  EXPECT_DOUBLE_EQ(back.mean_sinking, 1.0 / 5);
}

TEST(Changes, LeaveOutWhatOnlyOneStateHas) {
  const World before = make_world(bonded_row(5));
  World now = before;
  now.disks.add({.position = {5.5, 0}});
  now.bonds.form({{4, 5}});
  const Changes changes = changes_between(before, now);
  EXPECT_EQ(changes.grains.size(), 5U);
  EXPECT_EQ(changes.bonds_formed + changes.contacts_gained, 0);
}

TEST(Changes, AreOfOneSpecimen) {
  const World world = make_world(bonded_row(5));
  World other = world;
  EXPECT_TRUE(same_specimen(world, other));
  other.disks.radius[2] *= 1 + 1e-7;
  EXPECT_TRUE(same_specimen(world, other)) << "as histories round it";
  other.disks.radius[2] = 0.4;
  EXPECT_FALSE(same_specimen(world, other));
  other = world;
  other.disks.role[4] = DiskRole::intruder;
  EXPECT_FALSE(same_specimen(world, other));
  other = world;
  remove_disks(other, {0, 0, 0, 0, 0});
  EXPECT_TRUE(same_specimen(world, other)) << "none was taken away";
  remove_disks(other, {0, 1, 0, 0, 0});
  other.disks.add({.position = {6, 0.5}});
  EXPECT_FALSE(same_specimen(world, other)) << "each row has such a disk, but not the same";
  World likewise = world, elsewhere = world;
  remove_disks(likewise, {0, 1, 0, 0, 0});
  EXPECT_TRUE(same_specimen(likewise, other));
  remove_disks(elsewhere, {0, 0, 1, 0, 0});
  EXPECT_FALSE(same_specimen(elsewhere, likewise)) << "another was taken away";
  other = world;
  other.box.width += 1;
  EXPECT_FALSE(same_specimen(world, other));
}

// A piston that is taken away takes its bonds and contacts along; they did not break.
TEST(Changes, LeaveOutWallsThatOnlyOneStateHas) {
  World before = make_world(bonded_row(5));
  const World now = before;
  before.walls.push_back({.point = {0, 0.5}, .normal = {0, -1}, .role = WallRole::piston});
  before.bonds.form({{0, kWallBase}, {1, kWallBase}});
  for (const Changes& changes : {changes_between(before, now), changes_between(now, before)}) {
    EXPECT_EQ(changes.bonds_broken + changes.bonds_formed, 0);
    EXPECT_EQ(changes.contacts_lost + changes.contacts_gained, 0);
  }
}

}  // namespace
}  // namespace quicksand
