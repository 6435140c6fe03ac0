// What the colours of grains say, and their legend.
#include "render/layers/colouring.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/render/worlds.h"

namespace quicksand {
namespace {

bool names(const ColourScale& scale, const std::string& label) {
  return std::ranges::find(scale.others, label, &Swatch::label) != scale.others.end();
}

TEST(Colouring, FixedGrainsLookLikeWallsInEveryColouring) {
  World world = worlds::arch_with_intruder();
  const int fixed = world.disks.add({.position = {0, 8}, .fixed = true});
  for (const ColouringInfo& known : colourings()) {
    const View view{.colouring = known.colouring};
    const ColouredGrains grains = colour_grains(world, view);
    const Colour wall = palette(view.theme).wall_body;
    EXPECT_EQ(grains.fill[static_cast<std::size_t>(fixed)], wall) << known.name;
    EXPECT_EQ(std::ranges::count(grains.fill, wall), 1) << known.name;
    EXPECT_TRUE(names(grains.scale, "fixed")) << known.name;
  }
}

TEST(Colouring, TheLegendNamesNoFixedGrainsWhereThereAreNone) {
  const ColouredGrains grains = colour_grains(worlds::arch_with_intruder(), View{});
  EXPECT_FALSE(names(grains.scale, "fixed"));
}

}  // namespace
}  // namespace quicksand
