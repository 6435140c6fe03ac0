#include "core/placing/placing.h"

#include <gtest/gtest.h>

#include "core/placing/remove_disks.h"
#include "core/world/ballistic.h"
#include "core/world/shaped_contact.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

World two_grains() {
  World world;
  world.box = {.width = 20, .height = 5, .sides = Sides::periodic, .floor = true};
  world.walls.push_back({});
  world.disks.add({.position = {9, 0.5}});
  world.disks.add({.position = {11.5, 0.5}});
  return world;
}

TEST(PlaceOnSurface, OfADiskIsItsLanding) {
  const World world = two_grains();
  const std::vector<ConvexPart> disk{{{{0, 0}}, 0.7}};
  for (const double x : {5.0, 8.8, 10.1, 12.4}) {
    const Vec2 landing = LandingSite(world).land(x, 0.7)->centre;
    EXPECT_LE(distance(place_on_surface(world, x, disk), landing), tolerance::scaled(1e-8)) << x;
  }
}

TEST(PlaceOnSurface, LaysAPlateOnTwoGrains) {
  const std::vector<ConvexPart> plate{{{{-2, 0}, {2, 0}}, 0.25}};
  EXPECT_LE(distance(place_on_surface(two_grains(), 10, plate), Vec2(10, 1.25)),
            tolerance::scaled(1e-8));
}

TEST(PlaceOnSurface, OfAFloorAboveTheGrainsIsOnThatFloor) {
  const std::vector<ConvexPart> disk{{{{0, 0}}, 0.7}};
  for (const Vec2& normal : {Vec2(0, 1), Vec2(0.6, 0.8), Vec2(-0.6, 0.8)}) {
    World world = two_grains();
    world.box.sides = Sides::open;
    world.walls.push_back({.point = {10, 9}, .normal = normal});
    for (const double x : {2.0, 10.0, 14.0}) {
      const double on_grains = LandingSite(two_grains()).land(x, 0.7)->centre.y();
      const double on_floor = 9 + (0.7 - normal.x() * (x - 10)) / normal.y();
      EXPECT_NEAR(place_on_surface(world, x, disk).y(), std::max(on_grains, on_floor),
                  tolerance::scaled(1e-8))
          << normal.x() << " at " << x;
    }
  }
}

TEST(RemoveDisks, LeavesTheOthersWithTheirBonds) {
  World world = two_grains();
  world.disks.add({.position = {12.5, 0.5}});
  world.disks.add({.position = {13.5, 0.5}});
  add_shape(world, {.position = {12.5, 1.25}}, std::vector<ConvexPart>{{{{-2, 0}, {2, 0}}, 0.25}});
  world.bonds.form({{1, 2}, {1, kWallBase}, {2, 3}, {2, kCornerBase}, {3, kCornerBase}});
  world.bonds.mark_initial();
  world.contacts = {{.pair = {0, kWallBase}}, {.pair = {3, kWallBase}}};
  remove_disks(world, {1, 1, 0, 0, 0});
  ASSERT_EQ(world.disks.size(), 3);
  EXPECT_EQ(world.disks.position[0], Vec2(12.5, 0.5));
  EXPECT_EQ(world.shapes.bodies[0].body, 2);
  std::vector<Pair> bonded;
  for (const Bond& bond : world.bonds.list) bonded.push_back(bond.pair);
  EXPECT_EQ(bonded, (std::vector<Pair>{{0, 1}, {0, kCornerBase}, {1, kCornerBase}}));
  EXPECT_EQ(world.bonds.initial, 3);
  EXPECT_EQ(world.bonds.broken, 0);
  ASSERT_EQ(world.contacts.size(), 1U);
  EXPECT_EQ(world.contacts[0].pair, (Pair{1, kWallBase}));
}

// A rectangle slides down beside a column, however narrow the room between them.
TEST(PlaceOnSurface, LetsAFlankPass) {
  const std::vector<ConvexPart> block{{{{-1, -3}, {1, -3}, {1, 3}, {-1, 3}}, 0.1}};
  for (const double clearance : {1e-2, 1e-3, 1e-4, 1e-5}) {
    World world;
    world.box = {.width = 30, .height = 10, .sides = Sides::open, .floor = true};
    world.walls.push_back({});
    for (int k = 0; k < 6; ++k)
      world.disks.add({.position = {15 + 1.1 + 0.5 + clearance, 0.5 + k}});
    EXPECT_NEAR(place_on_surface(world, 15, block).y(), 3.1, 1e-8) << clearance;
  }
}

}  // namespace
}  // namespace quicksand
