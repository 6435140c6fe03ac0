#include "core/world/shaped_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/shapes/intruder_shapes.h"
#include "core/world/neighbors.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

constexpr Box kOpen{.sides = Sides::open};

// A capsule along y, 1 d thick.
const std::vector<ConvexPart> kUpright{{{{0, -1}, {0, 1}}, 0.5}};

TEST(ShapedBody, HasTheMassOfItsArea) {
  World world{.box = kOpen};
  const int body = add_shape(world, {.position = {2, 3}, .density = 2}, kUpright);
  const double area = 2 + std::numbers::pi / 4;
  EXPECT_NEAR(world.disks.mass[body], 2 * area * 4 / std::numbers::pi, tolerance::rounding(10));
  EXPECT_NEAR(std::numbers::pi * std::pow(world.disks.radius[body], 2), area,
              tolerance::rounding());
  EXPECT_EQ(world.disks.position[body], Vec2(2, 3));
  EXPECT_NEAR(1 / world.disks.inverse_mass[body].z(), world.shapes.bodies[0].inertia,
              tolerance::rounding(10));
}

TEST(ShapedBody, TouchesADiskAtItsFlankAndAtItsEnd) {
  World world{.box = kOpen};
  world.disks.add({.position = {1.25, 0.5}});
  world.disks.add({.position = {0, 2.5}});
  add_shape(world, {}, kUpright);
  Vec2 normal;
  EXPECT_NEAR(world.gap({0, kCornerBase}, &normal), 0.25, tolerance::rounding());
  EXPECT_LE(distance(normal, Vec2(-1, 0)), tolerance::rounding());
  EXPECT_NEAR(world.gap({1, kCornerBase}, &normal), 0.5, tolerance::rounding());
  EXPECT_LE(distance(normal, Vec2(0, -1)), tolerance::rounding());
  world.disks.angle[2] = std::numbers::pi / 2;
  EXPECT_NEAR(world.gap({0, kCornerBase}), std::hypot(0.25, 0.5) - 1, tolerance::rounding());
}

TEST(ShapedBody, LiesOnAWallWithTwoCorners) {
  World world{.box = kOpen};
  world.walls.push_back({});
  add_shape(world, {.position = {0, 1.5}}, kUpright);
  world.disks.angle[0] = std::numbers::pi / 2;
  for (const int corner : {0, 1})
    EXPECT_NEAR(world.gap({kCornerBase + corner, kWallBase}), 1, tolerance::rounding());
  world.disks.position[0].y() = 0.5;
  const std::vector<Pair> touching{{kCornerBase, kWallBase}, {kCornerBase + 1, kWallBase}};
  EXPECT_EQ(pairs_within(world, 1e-9), touching);
}

TEST(ShapedBody, NeighborsAreThoseOfBruteForceWhileItMoves) {
  Random random{5};
  World world;
  world.box = {.width = 20, .sides = Sides::periodic};
  world.walls.push_back({});
  for (int i = 0; i < 150; ++i)
    world.disks.add({.position = {20 * random.uniform(), 20 * random.uniform()}});
  const int body =
      add_shape(world, {.position = {18, 10}},
                std::vector<ConvexPart>{
                    {{{-3, 0}, {3, 0}}, 0.1}, {{{0, -2}, {1, 0}, {-1, 0}}, 0.3}, {{{0, 3}}, 0.7}});
  NeighborList list;
  for (int k = 0; k < 40; ++k) {
    constexpr double kDistance = 0.2;
    std::vector<Pair> near;
    for (const Pair& pair : list.pairs(world, kDistance))
      if (world.gap(pair) <= kDistance) near.push_back(pair);
    std::vector<Pair> all;
    for (int i = 0; i < 151; ++i)
      for (int j = i + 1; j < 151; ++j)
        if (i != body && j != body && world.gap({i, j}) <= kDistance) all.push_back({i, j});
    for (int i = 0; i < 150; ++i) {
      for (const int first : {0, 2, 5})
        if (world.gap({i, kCornerBase + first}) <= kDistance)
          all.push_back({i, kCornerBase + first});
      if (world.gap({i, kWallBase}) <= kDistance) all.push_back({i, kWallBase});
    }
    for (int corner = 0; corner < 6; ++corner)
      if (world.gap({kCornerBase + corner, kWallBase}) <= kDistance)
        all.push_back({kCornerBase + corner, kWallBase});
    std::ranges::sort(all);
    EXPECT_EQ(near, all);
    world.disks.position[body] += Vec2(0.05, -0.02);
    world.disks.angle[body] += 0.04;
  }
}

// Second difference of the gap along a straight motion with spin, against its closed form.
TEST(ShapedBody, TurningRateIsTheSecondDerivativeOfTheGap) {
  World world{.box = kOpen};
  world.walls.push_back({});
  world.disks.add({.position = {1.05, 0.4}});
  world.disks.add({.position = {0.3, 2.2}});
  add_shape(world, {}, kUpright);
  world.disks.angle[2] = 0.2;
  const std::vector<Vec3> velocity{{0.3, 1.1, 0}, {-0.7, 0.2, 0}, {0.4, 0.5, 1.7}, {0, 0, 0}};
  for (const Pair pair : {Pair{0, kCornerBase}, Pair{1, kCornerBase}, Pair{kCornerBase, kWallBase},
                          Pair{kCornerBase + 1, kWallBase}}) {
    constexpr double kShort = 1e-4;
    const auto gap = [&](double t) { return shaped_contact_after(world, pair, velocity, t).gap; };
    const double second = (gap(kShort) - 2 * gap(0) + gap(-kShort)) / (kShort * kShort);
    EXPECT_NEAR(shaped_turning_rate(world, pair, velocity), second, tolerance::scaled(1e-5))
        << pair.a << " " << pair.b;
  }
}

TEST(ShapedBody, KnowsItsExtent) {
  World world{.box = kOpen};
  add_shape(world, {.position = {0, 5}}, kUpright);
  EXPECT_NEAR(lowest_point(world, 0), 3.5, tolerance::rounding(10));
  EXPECT_NEAR(highest_point_of(world, 0), 6.5, tolerance::rounding(10));
  EXPECT_NEAR(half_width(world, 0), 0.5, tolerance::rounding(10));
}

TEST(ShapedBody, OfAVaneTheHalfWidthIsItsRadiusAtEachAngle) {
  World world{.box = kOpen};
  add_shape(world, {}, parts_of(VaneIntruder{.blades = 4, .radius = 3, .thickness = 0.3}));
  for (const double angle : {0.0, 0.3, std::numbers::pi / 4, 2.0}) {
    world.disks.angle[0] = angle;
    EXPECT_NEAR(half_width(world, 0), 3, tolerance::rounding(10)) << angle;
  }
}

}  // namespace
}  // namespace quicksand
