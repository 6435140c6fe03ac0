// Walls as they are drawn.
#include <gtest/gtest.h>

#include "render/layers/packing.h"

namespace quicksand::test {
namespace {

// Windows are chosen in pixels, so that their edge may lie a rounding error above the floor.
TEST(Walls, AFloorAlongTheEdgeOfTheWindowIsDrawn) {
  World world;
  world.box = {.width = 20, .height = 10, .sides = Sides::open, .floor = false};
  world.walls.push_back({.point = Vec2(0, 0), .normal = Vec2(0, 1)});
  const auto segments = [&](double low) {
    const WorldRect window{Vec2(0, low), Vec2(20, 10)};
    const Camera camera(window, {.width = 200, .height = 100});
    DrawList list(200, 120, Colour{});
    draw_walls(list, world, View{}, Panel{camera, {.width = 200, .height = 120}}, 12);
    return list.segments().size();
  };
  EXPECT_GT(segments(0), 0u);
  EXPECT_EQ(segments(1e-13), segments(0));
  EXPECT_EQ(segments(0.5), 0u) << "it is out of sight";
}

}  // namespace
}  // namespace quicksand::test
