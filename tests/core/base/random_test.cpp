#include "core/base/random.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

// Published test values of SplitMix64; runs of today must be repeatable on any system.
TEST(Random, GivesThePublishedNumbers) {
  Random zero{0}, other{1234567};
  EXPECT_EQ(zero.next(), 0xE220A8397B1DCDAFULL);
  EXPECT_EQ(zero.next(), 0x6E789E6AA1B965F4ULL);
  EXPECT_EQ(other.next(), 6457827717110365317ULL);
}

TEST(Random, IsWhollyDescribedByItsState) {
  Random original{7};
  for (int k = 0; k < 5; ++k) original.next();
  Random copy{original.state};
  EXPECT_EQ(copy.next(), original.next());
}

TEST(Random, UniformNumbersFillTheUnitIntervalEvenly) {
  Random random{3};
  constexpr int kNumbers = 100000, kBins = 10;
  std::array<int, kBins> count{};
  for (int k = 0; k < kNumbers; ++k) {
    const double x = random.uniform();
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    ++count[static_cast<std::size_t>(x * kBins)];
  }
  // Five standard deviations.
  for (int n : count) EXPECT_NEAR(n, 10000, tolerance::sampled(475));
}

}  // namespace
}  // namespace quicksand
