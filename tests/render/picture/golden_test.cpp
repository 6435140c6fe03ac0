// One feature a picture.
#include "tests/support/render/golden.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/scene/scenario.h"
#include "render/picture/renderer.h"
#include "tests/support/render/worlds.h"

namespace quicksand {
namespace {

// Only the packing, small.
View bare() {
  return {.width = 200,
          .height = 150,
          .broken_bonds = false,
          .legend = false,
          .scale_bar = false,
          .numbers = false};
}

class Golden : public testing::Test {
 protected:
  static void SetUpTestSuite() { renderer = std::make_unique<Renderer>(); }
  static void TearDownTestSuite() { renderer.reset(); }
  static Image draw(const World& world, const View& view,
                    const std::vector<std::string>& caption = {}) {
    return renderer->draw(world, view, caption);
  }
  static std::unique_ptr<Renderer> renderer;
};
std::unique_ptr<Renderer> Golden::renderer;

TEST_F(Golden, ActiveBondsIntruderAndPeriodicImages) {
  golden::expect_same(draw(worlds::arch_with_intruder(), bare()), "active_bonds");
}

TEST_F(Golden, InitialBondsAndBrokenBonds) {
  View view = bare();
  view.colouring = Colouring::initial_bonds;
  view.broken_bonds = true;
  golden::expect_same(draw(worlds::arch_with_intruder(), view), "initial_bonds");
}

TEST_F(Golden, SpeedInTheDarkWithOrientation) {
  View view = bare();
  view.theme = Theme::dark;
  view.colouring = Colouring::speed;
  view.orientation = true;
  golden::expect_same(draw(worlds::arch_with_intruder(), view), "speed_dark");
}

TEST_F(Golden, BondNetwork) {
  View view = bare();
  view.bonds = true;
  golden::expect_same(draw(worlds::arch(), view), "bonds");
}

TEST_F(Golden, ForceNetwork) {
  View view = bare();
  view.forces = true;
  view.force_scale = 10;
  golden::expect_same(draw(worlds::arch(), view), "forces");
}

TEST_F(Golden, WallsAndPiston) {
  View view = bare();
  view.colouring = Colouring::coordination;
  golden::expect_same(draw(worlds::between_walls(), view), "walls");
}

TEST_F(Golden, LegendAsAStrip) {
  const View view{.width = 320,
                  .height = 400,
                  .bonds = true,
                  .physical = PhysicalScale{.grain_diameter = 5e-4}};
  golden::expect_same(draw(worlds::arch_with_intruder(), view, {"An arch"}), "legend_strip");
}

TEST_F(Golden, LegendAsAColumnWithACloseUp) {
  World world = worlds::arch_with_intruder();
  world.box.height = 40;
  const View view{.width = 480,
                  .height = 320,
                  .theme = Theme::dark,
                  .colouring = Colouring::pressure,
                  .forces = true};
  golden::expect_same(draw(world, view, {"An arch", "pushed"}), "legend_column");
}

TEST_F(Golden, PanelsUnderOneKey) {
  const World first = worlds::arch(), second = worlds::arch_with_intruder();
  const View view{.width = 480, .height = 330, .expects_intruder = true};
  const SideBySide panels[] = {{first, view, "a  before"}, {second, view, "b  pushed"}};
  golden::expect_same(renderer->draw_panels(panels), "panels");
}

Image part_of(const Image& picture, int x, int y, int width, int height) {
  Image part(width, height);
  for (int row = 0; row < height; ++row)
    std::copy_n(picture.pixel(x, y + row), 3 * width, part.pixel(0, row));
  return part;
}

TEST_F(Golden, EachPanelNamesTheMethodAndTheUnitsOfItsOwnScene) {
  const World world = worlds::arch();
  const View exact{.width = 480, .height = 330};
  View swept = exact;
  swept.method = "NSCD, 50 sweeps";
  const auto drawn = [&](const View& left, const View& right) {
    const SideBySide panels[] = {{world, left, "a"}, {world, right, "a"}};
    return renderer->draw_panels(panels);
  };
  const auto left = [](const Image& picture) { return part_of(picture, 0, 0, 240, 200); };
  const auto right = [](const Image& picture) { return part_of(picture, 240, 0, 240, 200); };
  const Image both = drawn(exact, swept);
  EXPECT_EQ(left(both), left(drawn(exact, exact)));
  EXPECT_EQ(right(both), right(drawn(swept, swept)));
  EXPECT_NE(left(both), right(both));
  EXPECT_EQ(left(drawn(swept, exact)), right(both));
}

// The bar of a panel is part of it, as long as its own scale says.
TEST_F(Golden, PanelsOfDifferentScalesHaveABarEach) {
  const World world = worlds::arch();
  World wide = world;
  wide.box.width = 24;
  const View view{.width = 480, .height = 330};
  View without = view;
  without.scale_bar = false;
  const auto drawn = [&](const World& left, const World& right, const View& like) {
    const SideBySide panels[] = {{left, like, "a"}, {right, like, "b"}};
    return renderer->draw_panels(panels);
  };
  const auto panel = [](const Image& picture, int x) { return part_of(picture, x, 0, 240, 200); };
  const auto numbers = [](const Image& picture, int x) { return part_of(picture, x, 0, 240, 60); };
  const Image bars = drawn(world, wide, view), none = drawn(world, wide, without);
  EXPECT_NE(panel(bars, 0), panel(none, 0));
  EXPECT_NE(panel(bars, 240), panel(none, 240));
  EXPECT_EQ(numbers(drawn(world, world, view), 0), numbers(drawn(world, world, without), 0))
      << "one bar in the key";
}

TEST_F(Golden, TheKeyOfPanelsNamesAnIntruderThatOneOfThemHas) {
  const World with = worlds::arch_with_intruder(), without = worlds::arch();
  const View view{.width = 480, .height = 330};
  const auto key = [&](const World& left, const World& right) {
    const SideBySide panels[] = {{left, view, "a"}, {right, view, "b"}};
    return part_of(renderer->draw_panels(panels), 0, 270, 480, 60);
  };
  EXPECT_EQ(key(with, without), key(without, with));
  EXPECT_NE(key(without, without), key(without, with));
}

TEST_F(Golden, SameWorldAndViewGiveTheSameBytes) {
  const World world = worlds::arch_with_intruder();
  const View view{.width = 400, .height = 300, .bonds = true, .forces = true};
  const Image first = draw(world, view);
  draw(worlds::arch(), View{.width = 640, .height = 480});
  EXPECT_EQ(draw(world, view), first);
  Renderer another;
  EXPECT_EQ(another.draw(world, view), first);
  EXPECT_EQ(draw(world, view), first);
}

}  // namespace
}  // namespace quicksand
