#include "render/base/nice_numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/scenario.h"
#include "render/draw/font.h"
#include "render/key/scale_bar.h"

namespace quicksand {
namespace {

TEST(NiceNumbers, AreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(nice_below(1), 1);
  EXPECT_DOUBLE_EQ(nice_below(1.99), 1);
  EXPECT_DOUBLE_EQ(nice_below(4.9), 2);
  EXPECT_DOUBLE_EQ(nice_below(7e-4), 5e-4);
  EXPECT_DOUBLE_EQ(nice_below(1000), 1000);
  EXPECT_DOUBLE_EQ(nice_above(1), 1);
  EXPECT_DOUBLE_EQ(nice_above(1.01), 2);
  EXPECT_DOUBLE_EQ(nice_above(2.01), 5);
  EXPECT_DOUBLE_EQ(nice_above(501), 1000);
  EXPECT_DOUBLE_EQ(nice_above(3e-7), 5e-7);
}

TEST(NiceNumbers, BoundWhatTheyAreNear) {
  for (int i = 0; i < 190; ++i) {
    const double x = 1e-6 * std::pow(1.17, i);
    EXPECT_LE(nice_below(x), x * (1 + 1e-8));
    EXPECT_GE(nice_above(x), x * (1 - 1e-8));
    EXPECT_GT(nice_below(x) * 2.51, x);
    EXPECT_LT(nice_above(x), x * 2.51);
  }
}

TEST(NiceNumbers, TicksLieInsideTheRangeAndAreFew) {
  for (int i = 0; i < 58; ++i) {
    const double high = 1e-3 * std::pow(1.37, i);
    const auto ticks = nice_ticks({0, high}, 5);
    EXPECT_GE(ticks.size(), 2U) << high;
    EXPECT_LE(ticks.size(), 5U) << high;
    EXPECT_EQ(ticks.front(), 0);
    EXPECT_LE(ticks.back(), high * (1 + 1e-8));
  }
}

TEST(NiceNumbers, AreShortInText) {
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(short_number(0.05), "0.05");
  EXPECT_EQ(short_number(20), "20");
  EXPECT_EQ(short_number(1500), "1500");
  EXPECT_EQ(short_number(1000 * (1 - 1e-15)), "1000");
  EXPECT_EQ(short_number(2e6), "2e6");
  EXPECT_EQ(short_number(-0.5), "−0.5");
  EXPECT_EQ(fixed_number(-0.001, 1), "0.0");
  EXPECT_EQ(fixed_number(-1.25, 1), "−1.2");
}

TEST(NiceNumbers, CarrySiPrefixes) {
  EXPECT_EQ(si_number(0.005, "m"), "5 mm");
  EXPECT_EQ(si_number(2e-5, "m"), "20 µm");
  EXPECT_EQ(si_number(1.5, "s"), "1.5 s");
  EXPECT_EQ(si_number(1500, "s"), "1500 s");
  EXPECT_EQ(si_number(0, "m"), "0 m");
}

TEST(ScaleBar, IsANiceNumberOfDiametersThatFits) {
  for (int i = 0; i < 20; ++i) {
    const double scale = 0.5 * std::pow(1.3, i);
    const double length = scale_bar_length(scale, 90);
    EXPECT_LE(length * scale, 90 * (1 + 1e-8));
    EXPECT_GT(length * scale, 90 / 2.51);
    EXPECT_DOUBLE_EQ(length, nice_below(length));
  }
}

TEST(ScaleBar, SaysMillimetresWherePhysicalValuesAreKnown) {
  EXPECT_EQ(plain(scale_bar_label(10, View{})), "10  d ");
  const View view{.physical = PhysicalScale{.grain_diameter = 5e-4}};
  EXPECT_EQ(scale_bar_label(10, view), "10 " + italic("d") + " = 5 mm");
}

}  // namespace
}  // namespace quicksand
