#include "core/bodies/contact_law.h"

#include <gtest/gtest.h>

#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

TEST(ContactLaw, RollingLengthOfEqualDisksIsTheCoefficientTimesTheirRadius) {
  EXPECT_NEAR(rolling_length(0.1, 0.5, 0.5), 0.05, tolerance::rounding());
  EXPECT_NEAR(rolling_length_on_wall(0.1, 0.5), 0.05, tolerance::rounding());
}

TEST(ContactLaw, RollingLengthDoesNotDependOnTheOrderOfTheBodies) {
  EXPECT_EQ(rolling_length(0.2, 0.5, 3), rolling_length(0.2, 3, 0.5));
}

TEST(ContactLaw, RollingLengthOfUnequalDisksIsTheHarmonicMean) {
  EXPECT_NEAR(rolling_length(1, 1, 3), 1.5, tolerance::rounding());
}

}  // namespace
}  // namespace quicksand
