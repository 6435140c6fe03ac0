#include "render/base/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/base/view.h"
#include "render/layers/colouring.h"
#include "tests/support/render/worlds.h"

namespace quicksand {
namespace {

double distance(Colour a, Colour b) { return std::hypot(a.r - b.r, a.g - b.g, a.b - b.b); }

// Lightness as seen, 0 to 100 (CIE L*).
double lightness(Colour c) {
  const auto linear = [](int v) {
    const double x = v / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

class InTheme : public testing::TestWithParam<Theme> {};

TEST_P(InTheme, ColoursThatMeanDifferentThingsAreDistinct) {
  const Palette& colours = palette(GetParam());
  std::vector<Colour> all(colours.bonds.begin(), colours.bonds.end());
  all.insert(all.end(), {colours.intruder, colours.broken, colours.background, colours.wall_body});
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(distance(all[i], all[j]), 40) << i << " " << j;
  }
  EXPECT_GT(distance(colours.compressive, colours.tensile), 100);
}

TEST_P(InTheme, NeighbouringCountsAreDistinct) {
  const Palette& colours = palette(GetParam());
  for (std::size_t i = 1; i < colours.counts.size(); ++i) {
    EXPECT_GT(distance(colours.counts[i], colours.counts[i - 1]), 30) << i;
  }
}

TEST_P(InTheme, ContinuousColoursGetLighterEvenly) {
  double previous = lightness(sequential_map(GetParam(), 0));
  for (int i = 1; i <= 20; ++i) {
    const double here = lightness(sequential_map(GetParam(), i / 20.0));
    EXPECT_GT(here - previous, 1.5) << i;
    EXPECT_LT(here - previous, 7) << i;
    previous = here;
  }
}

TEST_P(InTheme, ValuesBeyondTheRangeHaveTheColoursOfItsEnds) {
  EXPECT_EQ(sequential_map(GetParam(), -1), sequential_map(GetParam(), 0));
  EXPECT_EQ(sequential_map(GetParam(), 2), sequential_map(GetParam(), 1));
  EXPECT_EQ(damage_map(GetParam(), 0), palette(GetParam()).bonds.front());
  EXPECT_EQ(damage_map(GetParam(), 1), palette(GetParam()).bonds.back());
}

TEST_P(InTheme, TextIsReadable) {
  const Palette& colours = palette(GetParam());
  EXPECT_GT(std::abs(lightness(colours.ink) - lightness(colours.background)), 75);
}

// From red over orange to blue in both, or a reader of one theme misreads the other.
TEST_P(InTheme, TheHuesOfBondsGoFromRedToBlue) {
  const std::array<Colour, 5>& bonds = palette(GetParam()).bonds;
  for (const std::size_t i : {0, 1, 2}) EXPECT_GT(bonds[i].r, bonds[i].b + 50) << i;
  for (const std::size_t i : {1, 2}) EXPECT_GT(bonds[i].g, bonds[i - 1].g + 40) << i;
  for (const std::size_t i : {3, 4}) EXPECT_GT(bonds[i].b, bonds[i].r + 30) << i;
}

INSTANTIATE_TEST_SUITE_P(Themes, InTheme, testing::Values(Theme::light, Theme::dark),
                         [](const auto& p) { return p.param == Theme::light ? "Light" : "Dark"; });

TEST(Colouring, NamesLeadBackToTheColourings) {
  for (const ColouringInfo& entry : colourings()) {
    EXPECT_EQ(info(entry.colouring).name, entry.name);
    EXPECT_FALSE(entry.description.empty());
  }
}

TEST(Colouring, EveryColouringColoursEveryDiskAndHasALegend) {
  const World world = worlds::arch_with_intruder();
  for (const ColouringInfo& entry : colourings()) {
    const ColouredGrains grains = colour_grains(world, View{.colouring = entry.colouring});
    EXPECT_EQ(grains.fill.size(), static_cast<std::size_t>(world.disks.size())) << entry.name;
    EXPECT_NE(grains.scale.swatches.empty(), !grains.scale.range.has_value()) << entry.name;
  }
}

// What a picture shows of a value under a network of forces stands in its legend with the same colour.
TEST(Colouring, TheLegendPalesWithTheGrains) {
  const World world = worlds::arch_with_intruder();
  for (const ColouringInfo& entry : colourings()) {
    View view{.colouring = entry.colouring};
    const ColouredGrains full = colour_grains(world, view);
    view.forces = true;
    const ColouredGrains pale = colour_grains(world, view);
    EXPECT_NE(pale.fill[0], full.fill[0]) << entry.name;
    const auto is_first = [&](const Swatch& swatch) { return swatch.colour == pale.fill[0]; };
    if (pale.scale.range)
      EXPECT_EQ(pale.scale.of_map(view.theme, 0.5),
                mix(full.scale.of_map(view.theme, 0.5), palette(view.theme).background,
                    paling_under_forces(view)))
          << entry.name;
    else
      EXPECT_TRUE(std::ranges::any_of(pale.scale.swatches, is_first)) << entry.name;
  }
}

TEST(Colouring, ActiveBondsCountFloorAndImagesButNotBrokenOnes) {
  const World world = worlds::arch();
  const auto fill = colour_grains(world, View{}).fill;
  const auto& bonds = palette(Theme::light).bonds;
  EXPECT_EQ(fill[0], bonds[2]);   // the next one and the floor
  EXPECT_EQ(fill[9], bonds[0]);   // broken off
  EXPECT_EQ(fill[11], bonds[1]);  // across the side
}

TEST(Colouring, BrokenBondsShowWhereNotAllHold) {
  const World world = worlds::arch();
  const auto fill = colour_grains(world, View{.colouring = Colouring::broken_bonds}).fill;
  EXPECT_EQ(fill[0], kCurveColours[0]);  // the next one and the floor hold
  EXPECT_EQ(fill[9], kCurveColours[1]);  // broken off
}

TEST(Colouring, ARangeThatIsGivenHoldsWhateverTheDataAre) {
  const World world = worlds::arch_with_intruder();
  const View view{.colouring = Colouring::speed, .colour_low = 2, .colour_high = 50};
  EXPECT_EQ(colour_grains(world, view).scale.range, (Range{2, 50}));
  EXPECT_NE(colour_grains(world, View{.colouring = Colouring::speed}).scale.range, (Range{2, 50}));
}

TEST(Colouring, TheLegendSaysThatARangeIsOfTheWholeRun) {
  const World world = worlds::arch_with_intruder();
  View view{.colouring = Colouring::speed, .colour_high = 50};
  const auto says = [&] {
    return colour_grains(world, view).scale.title.find("range of the whole run") !=
           std::string::npos;
  };
  EXPECT_FALSE(says());
  view.colours_of_run = true;
  EXPECT_TRUE(says());
}

TEST(Colouring, FewFastGrainsDoNotSetTheRange) {
  std::vector<double> values(200, 0.9);
  values[7] = 1000;
  EXPECT_EQ(range_of(values).high, 1);
  EXPECT_EQ(range_of({0, 0, 0}).high, 1);
  EXPECT_EQ(range_of({}).high, 1);
}

}  // namespace
}  // namespace quicksand
