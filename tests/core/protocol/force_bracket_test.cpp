#include "core/protocol/force_bracket.h"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

// Searches with a thing that moves at forces above `threshold`.
ForceBracket search(double threshold, double first, double tolerance) {
  ForceBracket bracket{.first = first};
  while (!bracket.done(tolerance)) bracket.record(bracket.next() > threshold);
  return bracket;
}

TEST(ForceBracket, HoldsTheThresholdWithinItsTolerance) {
  for (const double threshold : {1.0, 0.317, 12345.6, 2e-5}) {
    for (const double first : {1.0, 3.0, 1e-2, 700.0}) {
      for (const double tolerance : {0.3, 0.02, 1e-6}) {
        const ForceBracket found = search(threshold, first, tolerance);
        if (!found.high || found.low == 0) {
          // Farther than the doublings reach.
          EXPECT_GT(std::abs(std::log2(threshold / first)), ForceBracket::kMostDoublings - 1);
          continue;
        }
        EXPECT_LE(found.low, threshold);
        EXPECT_GT(*found.high, threshold);
        EXPECT_LE(*found.high - found.low, tolerance * *found.high);
        const double doublings = std::abs(std::log2(threshold / first)) + 3;
        EXPECT_LE(found.trials, doublings + std::ceil(std::log2(1 / tolerance)));
      }
    }
  }
}

TEST(ForceBracket, DoublesUntilItMovesThenTriesTheMiddle) {
  ForceBracket bracket{.first = 3};
  EXPECT_EQ(bracket.next(), 3);
  bracket.record(false);
  EXPECT_EQ(bracket.next(), 6);
  bracket.record(true);
  EXPECT_EQ(bracket.next(), 4.5);
  EXPECT_EQ(bracket.low, 3);
  EXPECT_EQ(bracket.high, 6);
  EXPECT_TRUE(bracket.done(0.5));
  EXPECT_FALSE(bracket.done(0.49));
}

TEST(ForceBracket, WhatMovesWithoutAForceIsFoundInTheFourthTrial) {
  const ForceBracket found = search(-1, 8, 0.02);
  EXPECT_EQ(found.low, 0);
  EXPECT_EQ(found.high, 0);
  EXPECT_EQ(found.trials, 4);
}

TEST(ForceBracket, WhatMovesAtAnyForceEndsAtTheSmallest) {
  const ForceBracket found = search(0, 8, 0.02);
  EXPECT_EQ(found.low, 0);
  EXPECT_EQ(*found.high, std::ldexp(8, -ForceBracket::kMostDoublings));
  EXPECT_EQ(found.trials, ForceBracket::kMostDoublings + 2);  // one of them without a force
}

TEST(ForceBracket, WhatNeverMovesEndsAtTheLargest) {
  const ForceBracket found = search(HUGE_VAL, 8, 0.02);
  EXPECT_EQ(found.low, std::ldexp(8, ForceBracket::kMostDoublings));
  EXPECT_FALSE(found.high);
  EXPECT_EQ(found.trials, ForceBracket::kMostDoublings + 1);
}

TEST(ForceBracket, EndsWhereTheToleranceIsBeyondTheNumbers) {
  EXPECT_EQ(search(1.0 / 3, 1, 0).trials, ForceBracket::kMostTrials);
}

}  // namespace
}  // namespace quicksand
