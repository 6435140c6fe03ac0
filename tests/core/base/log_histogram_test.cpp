#include "core/base/log_histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace quicksand {
namespace {

TEST(LogHistogram, QuantilesAreUpperEndsOfBinsThatHoldTheValue) {
  LogHistogram h;
  for (int k = 1; k <= 1000; ++k) h.add(1e-3 * k);
  const double bin = std::pow(10.0, 1.0 / LogHistogram::kBinsPerDecade);
  for (const double share : {0.1, 0.5, 0.9, 0.99}) {
    EXPECT_GE(h.quantile(share), share);
    EXPECT_LE(h.quantile(share), share * bin);
  }
  EXPECT_EQ(h.quantile(1), 1);
  EXPECT_EQ(h.total(), 1000);
}

TEST(LogHistogram, ZerosAndWhatIsNotFiniteAreCountedAtTheEnds) {
  LogHistogram h;
  EXPECT_EQ(h.quantile(0.5), 0);
  h.add(0);
  h.add(1e-300);
  h.add(std::numeric_limits<double>::infinity());
  h.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(h.counts.front(), 2);
  EXPECT_EQ(h.counts.back(), 2);
  EXPECT_EQ(h.total(), 4);
  h.add(1);
  EXPECT_EQ(h.quantile(1), std::numeric_limits<double>::infinity()) << "none is forgotten";
}

}  // namespace
}  // namespace quicksand
