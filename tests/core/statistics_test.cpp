#include "core/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace quicksand::test {
namespace {

TEST(Statistics, ThreeValuesHaveTheErrorOfThePenAndPaper) {
  const std::array<double, 3> values{1, 2, 6};
  EXPECT_DOUBLE_EQ(mean(values), 3);
  EXPECT_DOUBLE_EQ(standard_error(values).value(), std::sqrt((4.0 + 1.0 + 9.0) / 6.0));
}

TEST(Statistics, OneValueTellsNoError) {
  const std::array<double, 1> one{7};
  EXPECT_EQ(mean(one), 7);
  EXPECT_FALSE(standard_error(one).has_value());
  EXPECT_FALSE(standard_error({}).has_value());
}

TEST(Statistics, EqualValuesFarFromZeroHaveNoError) {
  const std::array<double, 4> values{1e9, 1e9, 1e9, 1e9};
  EXPECT_EQ(standard_error(values).value(), 0);
}

}  // namespace
}  // namespace quicksand::test
