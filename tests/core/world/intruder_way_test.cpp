#include "core/world/intruder_way.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/checkpoint/checkpoint.h"
#include "core/measures/measures.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/tolerance.h"
#include "tests/support/temporary_folder.h"

namespace quicksand {
namespace {

// An intruder of 3 d over one grain, in a periodic box of 10 d.
World intruder_and_grain() {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = 10, .height = 20, .sides = Sides::periodic, .floor = true};
  scene.disks = {{.position = {5, 0.5}},
                 {.position = {5, 8}, .radius = 1.5, .role = Role::intruder}};
  return make_world(scene);
}

void move_to(World& world, const Vec2& place) {
  world.disks.position[1] = place;
  record_way(world);
}

TEST(IntruderWay, BeginsWhereTheIntruderWasPlacedAndKeepsTheSurfaceThatItMet) {
  World world = intruder_and_grain();
  record_way(world);
  EXPECT_EQ(world.way.places, std::vector<Vec2>{Vec2(5, 8)});
  EXPECT_EQ(world.way.surface, 1);
  world.disks.position[0].y() = 0.25;  // the packing sinks, its first surface stays
  move_to(world, {5, 7});
  EXPECT_EQ(world.way.surface, 1);
  EXPECT_EQ(measure(world).depth, 1 - (7 - 1.5));
}

TEST(IntruderWay, TakesAPlaceAtEveryQuarterOfTheRadius) {
  World world = intruder_and_grain();
  for (int k = 0; k <= 300; ++k) move_to(world, {5, 8 - 0.01 * k});
  ASSERT_EQ(world.way.places.size(), 1 + 7U) << "300 steps of 0.01 d, a place at each 0.38 d";
  for (std::size_t k = 1; k < world.way.places.size(); ++k)
    EXPECT_GT((world.way.places[k] - world.way.places[k - 1]).norm(), 1.5 / 4);
  EXPECT_EQ(way_so_far(world).places.back(), Vec2(5, 5)) << "the present place is always known";
}

TEST(IntruderWay, IsNothingWithoutAnIntruder) {
  World world = make_world(column(Method::automatic, 3));
  record_way(world);
  EXPECT_TRUE(world.way.places.empty());
  EXPECT_TRUE(way_so_far(world).places.empty());
  EXPECT_EQ(distances_from_way(world, 7), std::vector<double>(3, 7));
}

TEST(IntruderWay, OfAnIntruderThatNobodyRecordedIsItsPlace) {
  World world = intruder_and_grain();
  EXPECT_NEAR(distances_from_way(world, 100)[0], 7.5, tolerance::rounding());
  EXPECT_EQ(measure(world).depth, 1 - 6.5);
}

TEST(DistanceFromWay, IsTakenThroughThePeriodicSide) {
  World world = intruder_and_grain();
  world.way.places = {{9.5, 8}, {10.5, 4}};  // straddles x = 10, not wrapped
  world.disks.position = {{0.5, 2}, {10.5, 4}};
  EXPECT_NEAR(distances_from_way(world, 100)[0], 2, tolerance::rounding()) << "below its end";
  world.disks.position[0] = {-0.5, 8};
  EXPECT_NEAR(distances_from_way(world, 100)[0], 0, tolerance::rounding()) << "on its beginning";
  world.disks.position[0] = {39.5, 10};
  EXPECT_NEAR(distances_from_way(world, 100)[0], 2, tolerance::rounding()) << "three boxes on";
  world.disks.position[0] = {7.5, 8};
  EXPECT_NEAR(distances_from_way(world, 100)[0], 2, tolerance::rounding());
  EXPECT_EQ(distances_from_way(world, 1.5)[0], 1.5) << "no farther than asked";
}

// Against all segments and images, for ways longer than the box is wide.
TEST(DistanceFromWay, IsThatOfTheNearestPointOfTheNearestImage) {
  Random random{3};
  World world = intruder_and_grain();
  Vec2 place(5, 30);
  for (int k = 0; k < 60; ++k) {
    place += Vec2(3 * random.uniform() - 1, 1 - 1.5 * random.uniform());
    world.way.places.push_back(place);
  }
  world.disks.position[1] = place;
  for (int k = 0; k < 25; ++k) {
    const Vec2 p(40 * random.uniform() - 20, 60 * random.uniform() - 10);
    world.disks.position[0] = p;
    double nearest = 1e9;
    for (std::size_t s = 0; s + 1 < world.way.places.size(); ++s)
      for (int image = -8; image <= 8; ++image)
        for (double t = 0; t <= 1; t += 0.02) {
          const Vec2 on = world.way.places[s] + t * (world.way.places[s + 1] - world.way.places[s]);
          nearest = std::min(nearest, (p + Vec2(10 * image, 0) - on).norm());
        }
    const double found = distances_from_way(world, 1e9)[0];
    EXPECT_LE(found, nearest + tolerance::rounding());
    EXPECT_GE(found, nearest - 0.03) << "half a step between the points of the search";
  }
}

// The whole protocol: the first place is where the push put it, and a restart keeps the way.
TEST(IntruderWay, IsRecordedByAPushAndKeptByACheckpoint) {
  Scenario scene = small_collapse(Method::automatic);
  Protocol protocol(scene, make_world(scene));
  while (protocol.world().intruder() < 0) protocol.advance();
  const World& world = protocol.world();
  ASSERT_EQ(world.way.places.size(), 1U);
  EXPECT_EQ(world.way.places[0].x(), 5) << "the middle of the box";
  while (protocol.advance() != Progress::finished) {
  }
  ASSERT_GE(world.way.places.size(), 2U);
  EXPECT_LT(world.way.places.back().y(), world.way.places.front().y());
  EXPECT_NEAR(measure(world).depth,
              world.way.surface - world.disks.position[world.intruder()].y() + 1.5,
              tolerance::rounding());

  const test::TemporaryFolder folder;
  write_checkpoint(folder.path() / "state.cbor", {world, protocol.state(), ""});
  const World read = read_checkpoint(folder.path() / "state.cbor").world;
  EXPECT_EQ(read.way.places, world.way.places);
  EXPECT_EQ(read.way.surface, world.way.surface);
  EXPECT_EQ(world_hash(read), world_hash(world));
}

}  // namespace
}  // namespace quicksand
