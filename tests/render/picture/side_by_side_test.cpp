// Worlds side by side: what their one key says holds for each of them.
#include "render/picture/side_by_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "render/base/palette.h"
#include "render/layers/colouring.h"
#include "tests/support/render/worlds.h"

namespace quicksand {
namespace {

class SideBySideTest : public testing::Test {
 protected:
  PanelsOverKey compose(const World& left, const World& right) const {
    const SideBySide panels[] = {{left, view_, "a"}, {right, view_, "b"}};
    return compose_side_by_side(panels, font_);
  }
  static World wider(World world) {
    world.box.width *= 3;
    return world;
  }
  static World pulled(World world, const Vec2& gravity) {
    world.gravity = gravity;
    return world;
  }
  static double scale(const Frame& panel) { return panel.packing.camera.scale(); }

  const Font font_{12};
  const World narrow_ = worlds::arch(), wide_ = wider(narrow_);
  View view_{.width = 800, .height = 400, .forces = true, .scale_bar = false, .force_scale = 10};
};

std::set<float> widths(const DrawList& list, Colour colour) {
  std::set<float> found;
  for (const SegmentShape& line : list.segments())
    if (line.colour == colour) found.insert(line.width);
  return found;
}

TEST_F(SideBySideTest, ALineOfOneWidthIsOneForceInPanelsOfAllScales) {
  const PanelsOverKey composed = compose(narrow_, wide_);
  ASSERT_GT(scale(composed.panels[0]), 1.5 * scale(composed.panels[1]));
  const Palette& colours = palette(Theme::light);
  for (const Colour colour : {colours.compressive, colours.tensile}) {
    const std::set<float> left = widths(composed.panels[0].list, colour),
                          right = widths(composed.panels[1].list, colour);
    ASSERT_GT(left.size(), 1U);
    ASSERT_EQ(left.size(), right.size());
    for (auto a = left.begin(), b = right.begin(); a != left.end(); ++a, ++b)
      EXPECT_NEAR(*a, *b, 1e-4 * *a);
  }
}

// Panels of one scale in which the narrow box has just these lines.
TEST_F(SideBySideTest, TheKeyNamesTheForceOfTheLinesOfAllPanels) {
  const PanelsOverKey both = compose(narrow_, wide_);
  EXPECT_EQ(both.key.glyphs(), compose(wide_, narrow_).key.glyphs());
  view_.force_scale *= scale(both.panels[0]) / scale(both.panels[1]);
  const PanelsOverKey like = compose(narrow_, narrow_);
  ASSERT_EQ(scale(like.panels[0]), scale(both.panels[0]));
  EXPECT_EQ(both.key.glyphs(), like.key.glyphs());
}

// Left to itself, a picture shows bonds where grains can form them, and contacts where they cannot.
TEST_F(SideBySideTest, PanelsHaveOneColouringThatShowsTheBondsOfAny) {
  World dry = narrow_;
  dry.grain_law.cohesion_force.reset();
  const View automatic;
  EXPECT_EQ(colouring_of(narrow_, automatic), Colouring::active_bonds);
  EXPECT_EQ(colouring_of(dry, automatic), Colouring::coordination);
  EXPECT_EQ(colouring_of(dry, {.colouring = Colouring::speed}), Colouring::speed);
  const auto key_of = [&](const World& left, const World& right, Colouring colouring) {
    view_.colouring = colouring;
    return compose(left, right).key.glyphs();
  };
  EXPECT_EQ(key_of(dry, narrow_, Colouring::automatic),
            key_of(dry, narrow_, Colouring::active_bonds));
  EXPECT_EQ(key_of(dry, dry, Colouring::automatic), key_of(dry, dry, Colouring::coordination));
  EXPECT_NE(key_of(dry, dry, Colouring::automatic), key_of(dry, dry, Colouring::active_bonds));
}

TEST_F(SideBySideTest, TheKeyNamesFixedGrainsThatOneOfThePanelsHas) {
  World held = narrow_;
  held.disks.add({.position = {4, 5}, .fixed = true});
  EXPECT_EQ(compose(held, narrow_).key.glyphs(), compose(narrow_, held).key.glyphs());
  EXPECT_NE(compose(held, narrow_).key.glyphs(), compose(narrow_, narrow_).key.glyphs());
}

// Lines of the arrow of gravity, its shaft first.
std::vector<SegmentShape> arrow(const DrawList& list) {
  std::vector<SegmentShape> found;
  std::ranges::copy_if(list.segments(), std::back_inserter(found),
                       [](const SegmentShape& line) { return line.width == 1.5F; });
  return found;
}

TEST_F(SideBySideTest, EachPanelSaysWhereItsOwnGravityPoints) {
  const World tilted = pulled(narrow_, {1, -1}), weightless = pulled(narrow_, {0, 0});
  const PanelsOverKey composed = compose(narrow_, tilted);
  EXPECT_TRUE(arrow(composed.key).empty());
  const auto down = arrow(composed.panels[0].list), aslant = arrow(composed.panels[1].list);
  ASSERT_EQ(down.size(), 3U);
  EXPECT_EQ(down[0].x0, down[0].x1);
  EXPECT_LT(down[0].y0, down[0].y1);
  ASSERT_EQ(aslant.size(), 3U);
  EXPECT_LT(aslant[0].x0, aslant[0].x1);
  EXPECT_LT(aslant[0].y0, aslant[0].y1);

  const PanelsOverKey without = compose(weightless, tilted);
  EXPECT_TRUE(arrow(without.panels[0].list).empty());
  EXPECT_EQ(scale(without.panels[0]), scale(without.panels[1])) << "equal boxes";
  EXPECT_EQ(arrow(without.panels[1].list).size(), 3U);
}

TEST_F(SideBySideTest, TheKeySaysWhereTheGravityOfAllPanelsPoints) {
  const World tilted = pulled(narrow_, {1, -1});
  const PanelsOverKey composed = compose(tilted, tilted);
  EXPECT_EQ(arrow(composed.key).size(), 3U);
  for (const Frame& panel : composed.panels) EXPECT_TRUE(arrow(panel.list).empty());
  view_.legend = false;
  EXPECT_TRUE(arrow(compose(tilted, narrow_).panels[0].list).empty());
}

TEST_F(SideBySideTest, TheKeyNamesPeriodicSidesThatOneOfThePanelsHas) {
  World between_walls = narrow_;
  between_walls.box.sides = Sides::walls;
  const auto letters = [](const PanelsOverKey& composed) { return composed.key.glyphs().size(); };
  const std::size_t named = letters(compose(narrow_, narrow_));
  EXPECT_EQ(letters(compose(between_walls, narrow_)), named);
  EXPECT_EQ(letters(compose(narrow_, between_walls)), named);
  EXPECT_LT(letters(compose(between_walls, between_walls)), named);
}

}  // namespace
}  // namespace quicksand
