#include "core/measures/linear_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quicksand {

std::optional<Mean> mean_of(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  const auto n = static_cast<double>(values.size());
  Mean mean;
  for (const double value : values) mean.value += value / n;
  if (values.size() == 1) return mean;
  double squares = 0;
  for (const double value : values) squares += (value - mean.value) * (value - mean.value);
  mean.error = std::sqrt(squares / (n * (n - 1)));
  return mean;
}

std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size());
  if (x.empty() || std::ranges::all_of(x, [&](double other) { return other == x[0]; }))
    return std::nullopt;
  const auto n = static_cast<double>(x.size());
  const double mean_x = mean_of(x)->value, mean_y = mean_of(y)->value;
  double spread = 0, product = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    spread += (x[k] - mean_x) * (x[k] - mean_x);
    product += (x[k] - mean_x) * (y[k] - mean_y);
  }
  Line line{.slope = product / spread};
  line.intercept = mean_y - line.slope * mean_x;
  if (x.size() < 3) return line;
  double squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double residual = y[k] - line.intercept - line.slope * x[k];
    squares += residual * residual;
  }
  const double variance = squares / (n - 2);
  line.slope_error = std::sqrt(variance / spread);
  line.intercept_error = std::sqrt(variance * (1 / n + mean_x * mean_x / spread));
  return line;
}

double slope_error_by(std::span<const double> x, std::span<const double> y_error) {
  assert(x.size() == y_error.size() && !x.empty());
  const double mean_x = mean_of(x)->value;
  double spread = 0, squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double off = x[k] - mean_x;
    spread += off * off;
    squares += off * off * y_error[k] * y_error[k];
  }
  return std::sqrt(squares) / spread;
}

}  // namespace quicksand
