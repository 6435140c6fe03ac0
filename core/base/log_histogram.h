// How numbers of many orders of magnitude are distributed: eight bins a decade, from 1e-16 to 1e8.
#pragma once

#include <cstdint>
#include <vector>

namespace quicksand {

struct LogHistogram {
  static constexpr int kBinsPerDecade = 8, kLowest = -16, kHighest = 8;
  static constexpr std::size_t kBins = (kHighest - kLowest) * kBinsPerDecade;

  // (kBins + 1) or empty; the last is of all above, and of what is not finite. Zeros and all below are in the first.
  std::vector<std::int64_t> counts;
  double largest = 0;

  void add(double x);
  std::int64_t total() const;
  // The upper end of the bin in which this share of the numbers ends, at most the largest; 0 of none. `share` is
  // from 0 to 1.
  double quantile(double share) const;
  // Lower end of a bin.
  static double edge(std::size_t bin);
};

}  // namespace quicksand
