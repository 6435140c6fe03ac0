#include "core/base/log_histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace quicksand {

void LogHistogram::add(double x) {
  if (counts.empty()) counts.resize(kBins + 1);
  // What is not a number is beyond all.
  if (std::isnan(x)) x = std::numeric_limits<double>::infinity();
  largest = std::max(largest, x);
  const double place = x > 0 ? kBinsPerDecade * (std::log10(x) - kLowest) : 0;
  ++counts[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(kBins)))];
}

std::int64_t LogHistogram::total() const {
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

double LogHistogram::edge(std::size_t bin) {
  return std::pow(10.0, kLowest + static_cast<double>(bin) / kBinsPerDecade);
}

double LogHistogram::quantile(double share) const {
  const double wanted = share * static_cast<double>(total());
  double seen = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    seen += static_cast<double>(counts[k]);
    if (seen >= wanted && seen > 0) return k < kBins ? std::min(edge(k + 1), largest) : largest;
  }
  return 0;
}

}  // namespace quicksand
