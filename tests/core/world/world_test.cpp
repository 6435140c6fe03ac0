#include "core/world/world.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

TEST(Geometry, SeparationGoesThroughTheNearestImage) {
  World world;
  world.box = {.width = 10, .sides = Sides::periodic};
  world.disks.add({.position = {0.5, 0}});
  world.disks.add({.position = {39, 2}});
  EXPECT_EQ(world.separation(0, 1), Vec2(-1.5, 2));
  EXPECT_EQ(world.separation(1, 0), Vec2(1.5, -2));
  EXPECT_NEAR(world.gap({0, 1}), 1.5, tolerance::rounding());
}

TEST(Geometry, WrappedPositionsLieInTheBox) {
  World world;
  world.box = {.width = 10, .sides = Sides::periodic};
  EXPECT_EQ(world.wrapped_x(-0.25), 9.75);
  EXPECT_EQ(world.wrapped_x(20), 0);
  EXPECT_EQ(world.wrapped_x(-1e-30), 0) << "not the width itself";
  world.box.sides = Sides::open;
  EXPECT_EQ(world.wrapped_x(-0.25), -0.25);
}

TEST(Geometry, NormalsPointFromTheFirstToTheSecondBody) {
  World world;
  world.box.sides = Sides::open;
  world.disks.add({.position = {0, 2}});
  world.disks.add({.position = {3, 2}});
  world.walls.push_back({});
  Vec2 normal;
  EXPECT_EQ(world.gap({0, 1}, &normal), 2);
  EXPECT_EQ(normal, Vec2(1, 0));
  EXPECT_EQ(world.gap({0, kWallBase}, &normal), 1.5);
  EXPECT_EQ(normal, Vec2(0, -1));
}

TEST(PairLaws, FollowTheRoles) {
  Scenario scene = column(Method::automatic, 2);
  scene.disks.push_back({.position = {0, 3.5}, .radius = 1.5, .role = DiskRole::intruder});
  scene.grain_law.friction = 0.1;
  scene.wall_law = ContactLaw{.friction = 0.2};
  scene.intruder_law = ContactLaw{.friction = 0.3};
  const World world = make_world(scene);
  EXPECT_EQ(world.law({0, 1}).friction, 0.1);
  EXPECT_EQ(world.law({0, kWallBase}).friction, 0.2);
  EXPECT_EQ(world.law({1, 2}).friction, 0.3);
  EXPECT_EQ(world.law({2, kWallBase}).friction, 0.3);
  EXPECT_EQ(world.intruder(), 2);
}

TEST(MakeWorld, UnnamedLawsAreThoseOfTheGrains) {
  Scenario scene = column(Method::automatic, 1, paper_law(10));
  const World world = make_world(scene);
  EXPECT_EQ(world.wall_law, world.grain_law);
  EXPECT_EQ(world.intruder_law, world.grain_law);
}

TEST(MakeWorld, BuildsTheBox) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = 6, .height = 6, .sides = Sides::walls, .floor = true};
  scene.walls.push_back({.point = {0, 6}, .normal = {0, -1}, .role = WallRole::piston});
  const World world = make_world(scene);
  ASSERT_EQ(world.walls.size(), 4U);
  EXPECT_EQ(world.walls[0].role, WallRole::floor);
  EXPECT_EQ(world.walls[3].role, WallRole::piston);
  // A disk in the middle sees every wall at three less its radius.
  World with_disk = world;
  with_disk.disks.add({.position = {3, 3}});
  for (int k = 0; k < 4; ++k) EXPECT_EQ(with_disk.gap({0, kWallBase + k}), 2.5) << k;
}

TEST(MakeWorld, BondsWhatTouchesIfTheSceneSaysSo) {
  Scenario scene = column(Method::automatic, 3, paper_law(10));
  scene.disks.push_back({.position = {1 + 4e-5, 0.5}});   // within the range of 5e-5
  scene.disks.push_back({.position = {-1 - 6e-5, 0.5}});  // not
  EXPECT_TRUE(make_world(scene).bonds.list.empty());
  scene.initial_bonds = InitialBonds::touching;
  const World world = make_world(scene);
  // Two in the column, one beside, three on the floor.
  EXPECT_EQ(world.bonds.list.size(), 6U);
  EXPECT_EQ(world.bonds.initial, 6);
  EXPECT_TRUE(world.bonds.find({0, 3}));
  EXPECT_FALSE(world.bonds.find({0, 4}));
}

// Bonds of every pair, by the range of its own law.
TEST(MakeWorld, BondsByTheLawOfThePair) {
  Scenario scene = column(Method::automatic, 1);
  scene.disks[0].position.y() += 0.5e-3;
  scene.wall_law = ContactLaw{.cohesion_force = 5, .cohesion_range = 1e-3};
  scene.initial_bonds = InitialBonds::touching;
  EXPECT_EQ(make_world(scene).bonds.list.size(), 1U);
}

// Everything that decides the future changes the hash.
TEST(WorldHash, SeesEveryPartOfTheWorld) {
  Scenario scene = column(Method::automatic, 3, paper_law(10));
  scene.initial_bonds = InitialBonds::touching;
  Simulation run(scene);
  run.advance(3);
  const std::vector<std::pair<const char*, std::function<void(World&)>>> changes{
      {"box", [](World& w) { w.box.width += 1; }},
      {"sides", [](World& w) { w.box.sides = Sides::periodic; }},
      {"gravity", [](World& w) { w.gravity = Vec2(0, -1.1); }},
      {"no gravity", [](World& w) { w.gravity.reset(); }},
      {"friction", [](World& w) { w.grain_law.friction = 0.31; }},
      {"no friction", [](World& w) { w.wall_law.friction.reset(); }},
      {"cohesion", [](World& w) { w.intruder_law.cohesion_force = 11; }},
      {"range", [](World& w) { w.grain_law.cohesion_range *= 2; }},
      {"position", [](World& w) { w.disks.position[1].x() += 1e-15; }},
      {"angle", [](World& w) { w.disks.angle[1] += 1e-15; }},
      {"velocity", [](World& w) { w.disks.velocity[2].z() += 1e-15; }},
      {"applied force", [](World& w) { w.disks.applied[0].x() += 1e-15; }},
      {"radius", [](World& w) { w.disks.radius[0] *= 1 + 1e-15; }},
      {"mass", [](World& w) { w.disks.mass[0] *= 1 + 1e-15; }},
      {"role", [](World& w) { w.disks.role[2] = DiskRole::intruder; }},
      {"wall", [](World& w) { w.walls[0].point.y() -= 1e-15; }},
      {"piston", [](World& w) { w.walls[0].force = 1; }},
      {"bond", [](World& w) { w.bonds.list[0].state = BondState::broken; }},
      {"bonding", [](World& w) { w.bonding = true; }},
      {"impulse", [](World& w) { w.contacts[0].impulse.x() *= 1 + 1e-15; }},
      {"impulse's step", [](World& w) { w.impulse_dt *= 2; }},
      {"time", [](World& w) { w.time += 1e-15; }},
      {"step", [](World& w) { ++w.step; }},
      {"random", [](World& w) { w.random.next(); }},
  };
  const std::uint64_t original = world_hash(run.world);
  EXPECT_EQ(world_hash(World(run.world)), original);
  for (const auto& [name, change] : changes) {
    World world = run.world;
    change(world);
    EXPECT_NE(world_hash(world), original) << name;
  }
}

}  // namespace
}  // namespace quicksand
