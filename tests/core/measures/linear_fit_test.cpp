#include "core/measures/linear_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/measures/critical_force.h"
#include "core/measures/shear_strength.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

using Values = std::vector<double>;

TEST(Mean, HasTheErrorOfItsValues) {
  const Mean mean = *mean_of(Values{1, 2, 3, 4});
  EXPECT_NEAR(mean.value, 2.5, tolerance::rounding());
  EXPECT_NEAR(*mean.error, std::sqrt(5.0 / 12), tolerance::rounding());
}

TEST(Mean, OfOneValueHasNoError) {
  EXPECT_EQ(mean_of(Values{7})->value, 7);
  EXPECT_FALSE(mean_of(Values{7})->error);
  EXPECT_FALSE(mean_of(Values{}));
}

TEST(Line, ThroughPointsOnALineIsThatLine) {
  const Line line = *fit_line(Values{1, 2, 5}, Values{5, 7, 13});
  EXPECT_NEAR(line.slope, 2, tolerance::rounding());
  EXPECT_NEAR(line.intercept, 3, tolerance::rounding());
  EXPECT_NEAR(*line.slope_error, 0, tolerance::rounding());
  EXPECT_NEAR(*line.intercept_error, 0, tolerance::rounding());
}

// x = -1, 0, 1 and y = 0, 0, 3: b = 3/2, a = 1, squares 1.5, S = 2.
TEST(Line, HasTheErrorsOfItsScatter) {
  const Line line = *fit_line(Values{-1, 0, 1}, Values{0, 0, 3});
  EXPECT_NEAR(line.slope, 1.5, tolerance::rounding());
  EXPECT_NEAR(line.intercept, 1, tolerance::rounding());
  EXPECT_NEAR(*line.slope_error, std::sqrt(0.75), tolerance::rounding());
  EXPECT_NEAR(*line.intercept_error, std::sqrt(0.5), tolerance::rounding());
}

TEST(Line, ThroughTwoPointsHasNoErrors) {
  const Line line = *fit_line(Values{1, 3}, Values{2, 8});
  EXPECT_NEAR(line.slope, 3, tolerance::rounding());
  EXPECT_FALSE(line.slope_error || line.intercept_error);
}

// Each y moves the slope by (x - X)/S times its own error.
TEST(Line, HasASlopeAsUncertainAsItsPointsAre) {
  const std::vector<double> x{0, 1, 5}, y{1, 4, 2}, error{0.1, 0.2, 0.4};
  double squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    std::vector<double> moved = y;
    moved[k] += error[k];
    squares += std::pow(fit_line(x, moved)->slope - fit_line(x, y)->slope, 2);
  }
  EXPECT_NEAR(slope_error_by(x, error), std::sqrt(squares), 1e-15);
}

TEST(Line, NeedsTwoPlaces) {
  EXPECT_FALSE(fit_line(Values{}, Values{}));
  EXPECT_FALSE(fit_line(Values{1}, Values{1}));
  EXPECT_FALSE(fit_line(Values{0.1, 0.1, 0.1}, Values{1, 2, 3}));
}

CriticalForce sheared(double depth, double force) {
  return {.phase = 2,
          .kind = SearchKind::shear,
          .depth = depth,
          .weight_above = 50 * depth,
          .force_low = force - 1,
          .force_high = force + 1};
}

TEST(ShearStrength, ThatGrowsWithTheWeightHasAFriction) {
  const std::vector<CriticalForce> forces{sheared(1, 14), sheared(1, 16), sheared(2, 29),
                                          sheared(2, 31), sheared(4, 59), sheared(4, 61)};
  const ShearStrength found = shear_strength(forces, 2, std::array{1.0, 2.0, 4.0, 9.0});
  ASSERT_EQ(found.depths.size(), 4U);
  EXPECT_EQ(found.depths[1].grains, 2);
  EXPECT_NEAR(found.depths[1].strength->value, 30, tolerance::rounding(10));
  EXPECT_NEAR(*found.depths[1].strength->error, 1, tolerance::rounding(10));
  EXPECT_EQ(found.depths[3].grains, 0);
  EXPECT_FALSE(found.depths[3].strength || found.depths[3].weight_above);
  EXPECT_NEAR(found.against_depth->slope, 15, tolerance::rounding(100));
  EXPECT_NEAR(found.against_depth->intercept, 0, tolerance::rounding(100));
  EXPECT_NEAR(found.against_weight->slope, 0.3, tolerance::rounding());
}

TEST(ShearStrength, OfSingleGrainsHasALine) {
  const std::vector<CriticalForce> forces{sheared(1, 10), sheared(2, 20), sheared(3, 40)};
  const ShearStrength found = shear_strength(forces, 2, std::array{1.0, 2.0, 3.0});
  EXPECT_NEAR(found.against_depth->slope, 15, tolerance::rounding(100));
}

// A standard error of two grains is uncertain by as much as itself. Lines through five depths with two grains each, of a
// known slope: about two of three must lie within their error of it.
TEST(ShearStrength, HasTheErrorsOfAFewGrainsADepth) {
  constexpr int kTrials = 2000;
  Random random{.state = 1};
  const auto deviate = [&] {  // nearly normal, of variance 1
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += random.uniform();
    return sum;
  };
  int inside = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<CriticalForce> forces;
    for (const double depth : {1.0, 2.0, 3.0, 4.0, 5.0})
      for (int grain = 0; grain < 2; ++grain)
        forces.push_back(sheared(depth, 15 * depth + deviate()));
    const Line line = *shear_strength(forces, 2, std::array{1.0, 2.0, 3.0, 4.0, 5.0}).against_depth;
    inside += std::abs(line.slope - 15) < *line.slope_error;
  }
  EXPECT_GT(inside, 0.6 * kTrials);
  EXPECT_LT(inside, 0.72 * kTrials);
}

TEST(ShearStrength, LeavesOutWhatNeverMovedAndOtherPhases) {
  std::vector<CriticalForce> forces{sheared(1, 10), sheared(1, 1000), sheared(1, 70)};
  forces[1].force_high.reset();
  forces[2].phase = 3;
  const ShearStrength found = shear_strength(forces, 2, std::array{1.0});
  EXPECT_EQ(found.depths[0].grains, 1);
  EXPECT_EQ(found.depths[0].never_moved, 1);
  EXPECT_EQ(found.depths[0].strength->value, 10);
  EXPECT_FALSE(found.against_depth);
}

}  // namespace
}  // namespace quicksand
