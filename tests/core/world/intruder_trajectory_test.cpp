#include "core/world/intruder_trajectory.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/checkpoint/checkpoint.h"
#include "core/measures/measures.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/shapes/intruder_shapes.h"
#include "core/world/shaped_contact.h"
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
                 {.position = {5, 8}, .radius = 1.5, .role = DiskRole::intruder}};
  return make_world(scene);
}

void move_to(World& world, const Vec2& place) {
  world.disks.position[1] = place;
  record_trajectory(world);
}

TEST(IntruderTrajectory, BeginsWhereTheIntruderWasPlacedAndKeepsTheSurfaceThatItMet) {
  World world = intruder_and_grain();
  record_trajectory(world);
  EXPECT_EQ(world.trajectory.places, std::vector<Vec2>{Vec2(5, 8)});
  EXPECT_EQ(world.trajectory.surface, 1);
  world.disks.position[0].y() = 0.25;  // the packing sinks, its first surface stays
  move_to(world, {5, 7});
  EXPECT_EQ(world.trajectory.surface, 1);
  EXPECT_EQ(measure(world).depth, 1 - (7 - 1.5));
}

TEST(IntruderTrajectory, TakesAPlaceAtEveryQuarterOfTheRadius) {
  World world = intruder_and_grain();
  for (int k = 0; k <= 300; ++k) move_to(world, {5, 8 - 0.01 * k});
  ASSERT_EQ(world.trajectory.places.size(), 1 + 7U)
      << "300 steps of 0.01 d, a place at each 0.38 d";
  for (std::size_t k = 1; k < world.trajectory.places.size(); ++k)
    EXPECT_GT((world.trajectory.places[k] - world.trajectory.places[k - 1]).norm(), 1.5 / 4);
  EXPECT_EQ(trajectory_so_far(world).places.back(), Vec2(5, 5))
      << "the present place is always known";
}

TEST(IntruderTrajectory, IsNothingWithoutAnIntruder) {
  World world = make_world(column(Method::automatic, 3));
  record_trajectory(world);
  EXPECT_TRUE(world.trajectory.places.empty());
  EXPECT_TRUE(trajectory_so_far(world).places.empty());
  EXPECT_EQ(distances_from_trajectory(world, 7), std::vector<double>(3, 7));
}

TEST(IntruderTrajectory, OfAnIntruderThatNobodyRecordedIsItsPlace) {
  World world = intruder_and_grain();
  EXPECT_NEAR(distances_from_trajectory(world, 100)[0], 7.5, tolerance::rounding());
  EXPECT_EQ(measure(world).depth, 1 - 6.5);
}

TEST(DistanceFromTrajectory, IsTakenThroughThePeriodicSide) {
  World world = intruder_and_grain();
  world.trajectory.places = {{9.5, 8}, {10.5, 4}};  // straddles x = 10, not wrapped
  world.disks.position = {{0.5, 2}, {10.5, 4}};
  EXPECT_NEAR(distances_from_trajectory(world, 100)[0], 2, tolerance::rounding())
      << "below its end";
  world.disks.position[0] = {-0.5, 8};
  EXPECT_NEAR(distances_from_trajectory(world, 100)[0], 0, tolerance::rounding())
      << "on its beginning";
  world.disks.position[0] = {39.5, 10};
  EXPECT_NEAR(distances_from_trajectory(world, 100)[0], 2, tolerance::rounding())
      << "three boxes on";
  world.disks.position[0] = {7.5, 8};
  EXPECT_NEAR(distances_from_trajectory(world, 100)[0], 2, tolerance::rounding());
  EXPECT_EQ(distances_from_trajectory(world, 1.5)[0], 1.5) << "no farther than asked";
}

// Against all segments and images, for trajectories longer than the box is wide.
TEST(DistanceFromTrajectory, IsThatOfTheNearestPointOfTheNearestImage) {
  Random random{3};
  World world = intruder_and_grain();
  Vec2 place(5, 30);
  for (int k = 0; k < 60; ++k) {
    place += Vec2(3 * random.uniform() - 1, 1 - 1.5 * random.uniform());
    world.trajectory.places.push_back(place);
  }
  world.disks.position[1] = place;
  for (int k = 0; k < 25; ++k) {
    const Vec2 p(40 * random.uniform() - 20, 60 * random.uniform() - 10);
    world.disks.position[0] = p;
    double nearest = 1e9;
    for (std::size_t s = 0; s + 1 < world.trajectory.places.size(); ++s)
      for (int image = -8; image <= 8; ++image)
        for (double t = 0; t <= 1; t += 0.02) {
          const Vec2 on = world.trajectory.places[s] +
                          t * (world.trajectory.places[s + 1] - world.trajectory.places[s]);
          nearest = std::min(nearest, (p + Vec2(10 * image, 0) - on).norm());
        }
    const double found = distances_from_trajectory(world, 1e9)[0];
    EXPECT_LE(found, nearest + tolerance::rounding());
    EXPECT_GE(found, nearest - 0.03) << "half a step between the points of the search";
  }
}

// A cone with a long shaft: its centre is far above its tip.
World cone_and_grain() {
  World world;
  world.box = {.width = 10, .height = 20, .sides = Sides::periodic, .floor = false};
  world.disks.add({.position = {5, 0.5}});
  add_shape(world, {.position = {5, 10}},
            parts_of(ConeIntruder{.width = 2, .angle = 60, .length = 6, .rounding = 0.1}));
  return world;
}

TEST(DistanceFromTrajectory, OfATallIntruderIsTakenFromItsAxis) {
  World world = cone_and_grain();
  const double low = lowest_point(world, 1) + 1, high = highest_point_of(world, 1) - 1;
  ASSERT_LT(low, 9);
  ASSERT_GT(high, 11);
  world.trajectory.places = {{5, 14}};  // it has come down by 4 d
  const auto of = [&](const Vec2& p) {
    world.disks.position[0] = p;
    return distances_from_trajectory(world, 100)[0];
  };
  EXPECT_NEAR(of({5.5, low}), 0.5, tolerance::rounding());
  EXPECT_NEAR(of({5, low - 1}), 1, tolerance::rounding()) << "at its tip";
  EXPECT_NEAR(of({15.5, 12}), 0.5, tolerance::rounding()) << "where its centre was";
  EXPECT_NEAR(of({4, high + 4}), 1, tolerance::rounding()) << "at its top when it was placed";
  EXPECT_NEAR(of({5, high + 6}), 2, tolerance::rounding());
}

// Against all places of the axis and all images, while the cone is moved to the sides, too.
TEST(DistanceFromTrajectory, OfATallIntruderIsThatOfTheNearestPointOfItsAxis) {
  Random random{5};
  World world = cone_and_grain();
  const double low = lowest_point(world, 1) - 10 + 1, high = highest_point_of(world, 1) - 10 - 1;
  Vec2 place(5, 10);
  for (int k = 0; k < 12; ++k) {
    world.trajectory.places.push_back(place);
    place += Vec2(6 * random.uniform() - 2, 1 - 4 * random.uniform());
  }
  world.disks.position[1] = place;
  std::vector<Vec2> places = world.trajectory.places;
  places.push_back(place);
  for (int k = 0; k < 40; ++k) {
    const Vec2 p(40 * random.uniform() - 20, 60 * random.uniform() - 40);
    world.disks.position[0] = p;
    double nearest = 1e9;
    for (std::size_t s = 0; s + 1 < places.size(); ++s)
      for (double t = 0; t <= 1; t += 0.01) {
        Vec2 away = p - places[s] - t * (places[s + 1] - places[s]);
        away.x() -= 10 * std::round(away.x() / 10);
        away.y() -= std::clamp(away.y(), low, high);
        nearest = std::min(nearest, away.norm());
      }
    const double found = distances_from_trajectory(world, 1e9)[0];
    EXPECT_LE(found, nearest + tolerance::rounding());
    EXPECT_GE(found, nearest - 0.04) << "half a step between the places of the search";
  }
}

// A billion boxes long: whoever looks at each image does not end.
TEST(DistanceFromTrajectory, OfAFlightThroughManyBoxesIsThatOfItsNearestPass) {
  World world = intruder_and_grain();
  world.disks.position[0] = {5, 8};
  move_to(world, {5, 10});
  move_to(world, {1e10 + 5, 10});
  EXPECT_NEAR(distances_from_trajectory(world, 100)[0], 2, tolerance::rounding());
  // It sinks by 3 d on a billion boxes, and so passes every height of every column at next to no distance.
  move_to(world, {2e10 + 5, 7});
  EXPECT_NEAR(distances_from_trajectory(world, 100)[0], 0, 1e-8);
}

// The whole protocol: the first place is where the push put it, and a restart keeps the trajectory.
TEST(IntruderTrajectory, IsRecordedByAPushAndKeptByACheckpoint) {
  Scenario scene = small_collapse(Method::automatic);
  Protocol protocol(scene, make_world(scene));
  while (protocol.world().intruder() < 0) protocol.advance();
  const World& world = protocol.world();
  ASSERT_EQ(world.trajectory.places.size(), 1U);
  EXPECT_EQ(world.trajectory.places[0].x(), 5) << "the middle of the box";
  while (protocol.advance() != Progress::finished) {
  }
  ASSERT_GE(world.trajectory.places.size(), 2U);
  EXPECT_LT(world.trajectory.places.back().y(), world.trajectory.places.front().y());
  EXPECT_NEAR(measure(world).depth,
              world.trajectory.surface - world.disks.position[world.intruder()].y() + 1.5,
              tolerance::rounding());

  const test::TemporaryFolder folder;
  write_checkpoint(folder.path() / "state.cbor", {world, protocol.state(), ""});
  const World read = read_checkpoint(folder.path() / "state.cbor").world;
  EXPECT_EQ(read.trajectory.places, world.trajectory.places);
  EXPECT_EQ(read.trajectory.surface, world.trajectory.surface);
  EXPECT_EQ(world_hash(read), world_hash(world));
}

}  // namespace
}  // namespace quicksand
