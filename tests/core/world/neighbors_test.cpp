#include "core/world/neighbors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/base/random.h"

namespace quicksand {
namespace {

struct Crowd {
  int disks = 200;
  Sides sides = Sides::open;
  double width = 30;
  double spread = 30;                    // side of the square that holds the centres
  double smallest = 0.4, largest = 0.6;  // radii
  double intruder = 0;                   // radius; 0: none
  double outlier = 0;                    // distance of one body that flew off; 0: none
  const char* name = "";
};

World random_world(const Crowd& crowd, Random& random) {
  World world;
  world.box = {.width = crowd.width, .sides = crowd.sides};
  for (int i = 0; i < crowd.disks; ++i)
    world.disks.add(
        {.position = {crowd.spread * (random.uniform() - 0.25),
                      crowd.spread * (random.uniform() - 0.25)},
         .radius = crowd.smallest + (crowd.largest - crowd.smallest) * random.uniform()});
  if (crowd.intruder > 0) world.disks.add({.position = {5, 5}, .radius = crowd.intruder});
  if (crowd.outlier > 0)
    for (double sign : {-1.0, 1.0})
      world.disks.add({.position = {sign * crowd.outlier, sign * crowd.outlier}});
  world.walls = {{}, {.point = {25, 0}, .normal = Vec2(-1, 0.2).normalized()}};
  return world;
}

std::vector<Pair> brute_force(const World& world, double distance) {
  std::vector<Pair> pairs;
  const int nd = world.disks.size();
  for (int i = 0; i < nd; ++i) {
    for (int j = i + 1; j < nd; ++j)
      if (world.gap({i, j}) <= distance) pairs.push_back({i, j});
    for (int k = 0; k < static_cast<int>(world.walls.size()); ++k)
      if (world.gap({i, kWallBase + k}) <= distance) pairs.push_back({i, kWallBase + k});
  }
  return pairs;
}

class Neighbors : public testing::TestWithParam<Crowd> {};

TEST_P(Neighbors, TheGridFindsWhatBruteForceFinds) {
  Random random{11};
  for (double distance : {0.0, 0.05, 0.3, 1.0, 7.0, 100.0}) {
    const World world = random_world(GetParam(), random);
    EXPECT_EQ(pairs_within(world, distance), brute_force(world, distance)) << distance;
  }
}

// Disks wander, walls move and new disks appear; the list must never miss a pair that is near.
TEST_P(Neighbors, TheListNeverMissesAPairUnderMotionAndGrowth) {
  Random random{12};
  World world = random_world(GetParam(), random);
  NeighborList list;
  for (int step = 0; step < 150; ++step) {
    const double distance = 0.05 * random.uniform();
    const std::vector<Pair>& pairs = list.pairs(world, distance);
    ASSERT_TRUE(std::ranges::is_sorted(pairs));
    ASSERT_TRUE(std::ranges::adjacent_find(pairs) == pairs.end()) << "a pair is listed twice";
    ASSERT_TRUE(std::ranges::includes(pairs, brute_force(world, distance))) << "in step " << step;
    for (Vec2& p : world.disks.position)
      p += 0.08 * Vec2(random.uniform() - 0.5, random.uniform() - 0.5);
    world.walls[0].point.y() += 0.02;
    // Now and then a few, sometimes more than are worth appending one by one.
    const int newcomers = step % 7 == 3 ? step % 10 : 0;
    for (int k = 0; k < newcomers; ++k)
      world.disks.add({.position = {20 * random.uniform(), 20 * random.uniform()}});
  }
}

INSTANTIATE_TEST_SUITE_P(
    Crowds, Neighbors,
    testing::Values(Crowd{.name = "open"}, Crowd{.sides = Sides::periodic, .name = "periodic"},
                    Crowd{.disks = 60, .sides = Sides::periodic, .width = 4, .name = "narrow"},
                    Crowd{.smallest = 0.05, .largest = 0.8, .name = "polydisperse"},
                    Crowd{.sides = Sides::periodic, .intruder = 4, .name = "intruder"},
                    Crowd{.disks = 40, .outlier = 1e7, .name = "far_flung"},
                    Crowd{.disks = 1, .name = "single"}),
    [](const testing::TestParamInfo<Crowd>& crowd) { return crowd.param.name; });

TEST(NeighborSearch, AnEmptyWorldHasNoPairs) {
  World world;
  world.walls.push_back({});
  EXPECT_TRUE(pairs_within(world, 1).empty());
  EXPECT_TRUE(NeighborList{}.pairs(world, 1).empty());
}

// A run that fails may have any speed; the search must still end, with all pairs.
TEST(NeighborSearch, AnyReachIsSearchedInBoundedTime) {
  for (Sides sides : {Sides::periodic, Sides::open}) {
    World world;
    world.box = {.width = 10, .sides = sides};
    for (double x : {0.5, 3.0, 7.0}) world.disks.add({.position = {x, x}});
    for (double distance : {1e6, 1e12, 1e200, std::numeric_limits<double>::infinity()})
      EXPECT_EQ(pairs_within(world, distance).size(), 3U) << distance;
  }
}

TEST(NeighborSearch, SeesThroughThePeriodicSides) {
  World world;
  world.box = {.width = 10, .sides = Sides::periodic};
  world.disks.add({.position = {0.3, 1}});
  world.disks.add({.position = {9.5, 1}});
  EXPECT_EQ(pairs_within(world, 0), (std::vector<Pair>{{0, 1}}));
  world.box.sides = Sides::open;
  EXPECT_TRUE(pairs_within(world, 0).empty());
}

// "Two steppers give the same bytes, whatever they did before": a list used on another world with
// disks at the same places must notice that they are of another size.
TEST(NeighborSearch, TheListNoticesAnotherWorld) {
  World small, large;
  small.box.sides = large.box.sides = Sides::open;
  for (double x : {0.0, 2.0}) {
    small.disks.add({.position = {x, 0}, .radius = 0.5});
    large.disks.add({.position = {x, 0}, .radius = 1});
  }
  NeighborList list;
  EXPECT_TRUE(list.pairs(small, 0.01).empty());
  EXPECT_EQ(list.pairs(large, 0.01), (std::vector<Pair>{{0, 1}}));
}

// The cells fit the small ones; to look into all that the large one covers would take years.
TEST(NeighborSearch, OfADiskTenBillionTimesLargerThanTheOthersAreFound) {
  World world;
  world.box = {.width = 0, .sides = Sides::open};
  for (int k = 0; k < 3; ++k) world.disks.add({.position = {k, 0}, .radius = 5e-7});
  world.disks.add({.position = {0, 5000.5}, .radius = 5000});
  EXPECT_EQ(pairs_within(world, 0.51), brute_force(world, 0.51));
  world.box = {.width = 1e5, .sides = Sides::periodic};
  EXPECT_EQ(pairs_within(world, 0.51), brute_force(world, 0.51));
}

}  // namespace
}  // namespace quicksand
