#include "render/base/camera.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/world/shaped_contact.h"
#include "tests/support/render/worlds.h"

namespace quicksand {
namespace {

constexpr double kTiny = 1e-9;

TEST(Camera, WorldPointsComeBackFromPixels) {
  const Camera camera({{-1, 0}, {9, 6}}, {20, 30, 300, 200});
  for (const Vec2& point : {Vec2(0, 0), Vec2(3.3, 5.1), Vec2(-7, 12)}) {
    EXPECT_LT((camera.to_world(camera.to_pixel(point)) - point).norm(), kTiny);
  }
}

TEST(Camera, HeightsGrowUpwardsAndLengthsAreTheSameInBothDirections) {
  const Camera camera({{0, 0}, {10, 10}}, {0, 0, 300, 200});
  EXPECT_LT(camera.to_pixel({0, 5}).y(), camera.to_pixel({0, 0}).y());
  EXPECT_NEAR((camera.to_pixel({1, 0}) - camera.to_pixel({0, 0})).norm(), camera.scale(), kTiny);
  EXPECT_NEAR((camera.to_pixel({0, 1}) - camera.to_pixel({0, 0})).norm(), camera.scale(), kTiny);
}

TEST(Camera, WindowIsInTheMiddleOfItsPlaceAndFillsItOneWay) {
  const Camera camera({{0, 0}, {10, 10}}, {10, 20, 300, 200});
  EXPECT_EQ(camera.covered(), (PixelRect{60, 20, 200, 200}));
  EXPECT_LT((camera.to_pixel({0, 10}) - Vec2(60, 20)).norm(), kTiny);
}

TEST(ViewWindow, IsTheBoxWhereverTheGrainsAre) {
  World world = worlds::arch();
  const WorldRect before = view_window(world, View{});
  world.disks.position[3] = {2, 30};
  const WorldRect after = view_window(world, View{});
  EXPECT_EQ(before.low, Vec2(0, 0));
  EXPECT_EQ(before.high, Vec2(8, 6));
  EXPECT_EQ(after.high, before.high);
}

TEST(ViewWindow, FollowsTheContentWhenAsked) {
  const World world = worlds::arch();
  const WorldRect window = view_window(world, View{.fit = Fit::content});
  EXPECT_EQ(window.low, Vec2(0, 0));
  EXPECT_NEAR(window.high.y(), 4.5, kTiny);
}

TEST(ViewWindow, ContainsTheBodiesWhereThereIsNoBox) {
  World world;
  world.box = {.width = 0, .height = 0, .sides = Sides::open, .floor = false};
  world.disks.add({.position = Vec2(-3, 2)});
  world.disks.add({.position = Vec2(4, -1), .radius = 2});
  const WorldRect window = view_window(world, View{});
  EXPECT_EQ(window.low, Vec2(-3.5, -3));
  EXPECT_EQ(window.high, Vec2(6, 2.5));
}

TEST(ViewWindow, ContainsTheCornersOfAShapedBody) {
  World world;
  world.box = {.width = 0, .height = 0, .sides = Sides::open, .floor = false};
  const ConvexPart rod{.corners = {{-4, 0}, {4, 0}}, .radius = 0.25};
  add_shape(world, {.position = Vec2(1, 2)}, {&rod, 1});
  const WorldRect window = view_window(world, View{});
  EXPECT_LT((window.low - Vec2(-3.25, 1.75)).norm(), kTiny);
  EXPECT_LT((window.high - Vec2(5.25, 2.25)).norm(), kTiny);
  world.disks.angle[0] = std::numbers::pi / 2;  // upright now
  const WorldRect turned = view_window(world, View{});
  EXPECT_LT((turned.low - Vec2(0.75, -2.25)).norm(), kTiny);
  EXPECT_LT((turned.high - Vec2(1.25, 6.25)).norm(), kTiny);
}

TEST(ViewWindow, OfTheViewGoesBeforeAll) {
  const View view{.window = WorldRect{{1, 2}, {3, 4}}};
  EXPECT_EQ(view_window(worlds::arch(), view).low, Vec2(1, 2));
  EXPECT_EQ(view_window(worlds::arch(), view).high, Vec2(3, 4));
}

TEST(ViewWindow, ThatFollowsHasTheIntruderInItsMiddleAndItsOwnSize) {
  World world;
  world.box = {.width = 10, .height = 20, .sides = Sides::periodic, .floor = true};
  View view{.window = WorldRect{{1, 2}, {3, 6}}, .follow = true};
  EXPECT_EQ(view_window(world, view), *view.window) << "there is none";
  world.disks.add({.position = Vec2(14, 5), .role = DiskRole::intruder});  // once around the box
  EXPECT_EQ(view_window(world, view), (WorldRect{{3, 3}, {5, 7}}));
  view.window.reset();
  EXPECT_EQ(view_window(world, view), (WorldRect{{-1, -5}, {9, 15}}));
}

TEST(ViewWindow, IsNotEmptyInAnEmptyWorld) {
  World world;
  world.box.width = 0;
  const Vec2 size = view_window(world, View{}).size();
  EXPECT_GT(size.x(), 0);
  EXPECT_GT(size.y(), 0);
}

}  // namespace
}  // namespace quicksand
