#include "core/ballistic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/measures.h"
#include "core/protocols.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

World box(Sides sides) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = 10, .height = 10, .sides = sides, .floor = true};
  return make_world(scene);
}

TEST(Landing, OnTheEmptyFloor) {
  const auto landing = land(box(Sides::periodic), 3, 0.5);
  ASSERT_TRUE(landing);
  EXPECT_EQ(landing->centre, Vec2(3, 0.5));
  EXPECT_EQ(landing->touched, kWallBase);
}

TEST(Landing, OnTheHighestDiskInItsWay) {
  World world = box(Sides::periodic);
  world.disks.add({.position = {3, 0.5}});
  world.disks.add({.position = {3.2, 4}, .radius = 1.5});
  world.disks.add({.position = {6, 9}});
  const auto landing = land(world, 4, 0.5);
  ASSERT_TRUE(landing);
  EXPECT_EQ(landing->touched, 1);
  EXPECT_NEAR(landing->centre.y(), 4 + std::sqrt(4 - 0.64), tolerance::rounding(10));
  world.disks.add({.position = landing->centre});
  EXPECT_NEAR(world.gap({1, 3}), 0, tolerance::rounding(10));
}

TEST(Landing, SeesDisksThroughThePeriodicSides) {
  World world = box(Sides::periodic);
  world.disks.add({.position = {29.8, 0.5}});  // two boxes to the right
  const auto landing = land(world, 0.2, 0.5);
  ASSERT_TRUE(landing);
  EXPECT_EQ(landing->touched, 0);
  world.box.sides = Sides::open;
  EXPECT_EQ(land(world, 0.2, 0.5)->touched, kWallBase);
}

TEST(Landing, NowhereWithoutFloor) {
  World world = box(Sides::open);
  world.walls.clear();
  EXPECT_FALSE(land(world, 1, 0.5));
}

TEST(Landing, TouchesATiltedFloorWithoutOverlap) {
  World world = box(Sides::open);
  world.walls = {{.point = {2, 1}, .normal = Vec2(-0.3, 1).normalized()}};
  const auto landing = land(world, 5, 0.5);
  ASSERT_TRUE(landing);
  world.disks.add({.position = landing->centre});
  EXPECT_NEAR(world.gap({0, kWallBase}), 0, tolerance::rounding(10));
}

// Sticking without restructuring: literature value 0.357 for large systems. [Meakin 1987]
TEST(BallisticDeposition, SlowVolumeFractionAndCoordinationAreTheKnownOnes) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = 400, .height = 120, .sides = Sides::periodic, .floor = true};
  scene.gravity = Vec2(0, -1);
  scene.grain_law.cohesion_force = 1e4;
  scene.phases = {{DepositPhase{.grains = 20000, .interval = 0}}};
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() != Progress::finished) {
  }
  const World& world = protocol.world();
  const double top = packing_top(world);
  const double bulk = volume_fraction(world, 0.3 * top, 0.8 * top);
  RecordProperty("volume_fraction", std::to_string(bulk));
  EXPECT_NEAR(bulk, 0.357, tolerance::sampled(0.01));
  // Each grain brings one contact; a few touch a second neighbour within the range by chance.
  const Sample sample = measure(world);
  EXPECT_EQ(sample.bonds_active, 20000);
  EXPECT_NEAR(sample.coordination, 2, tolerance::sampled(0.02));
  EXPECT_EQ(world.step, 0) << "no dynamics";
}

}  // namespace
}  // namespace quicksand
