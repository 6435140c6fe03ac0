// Medians, quantiles, and the exponent of a power law.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/measures/linear_fit.h"

namespace quicksand::bench {

// The middle value, or the mean of the two; 0 of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// The value below which this share of them lies; 0 of none.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const double last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::lround(share * last))];
}

// p of the least-squares fit y = c x^p; two x must differ.
inline double exponent(std::vector<double> x, std::vector<double> y) {
  for (double& value : x) value = std::log(value);
  for (double& value : y) value = std::log(value);
  return fit_line(x, y)->slope;
}

}  // namespace quicksand::bench
