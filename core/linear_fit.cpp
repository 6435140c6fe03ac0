#include "core/linear_fit.h"

#include <cassert>
#include <cmath>
#include <vector>

namespace quicksand {

namespace {

struct WeightedLine {
  Line line;
  double sum = 0;     // of the weights
  double mean_x = 0;  // X in the header
  double spread = 0;  // S in the header
};

std::optional<WeightedLine> weighted_line(std::span<const double> x, std::span<const double> y,
                                          const std::vector<double>& weights) {
  assert(x.size() == y.size() && x.size() == weights.size());
  WeightedLine fit;
  double mean_y = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    fit.sum += weights[k];
    fit.mean_x += weights[k] * x[k];
    mean_y += weights[k] * y[k];
  }
  if (fit.sum == 0) return std::nullopt;
  fit.mean_x /= fit.sum;
  mean_y /= fit.sum;
  double product = 0;
  bool differ = false;
  for (std::size_t k = 0; k < x.size(); ++k) {
    differ = differ || x[k] != x[0];
    fit.spread += weights[k] * (x[k] - fit.mean_x) * (x[k] - fit.mean_x);
    product += weights[k] * (x[k] - fit.mean_x) * (y[k] - mean_y);
  }
  if (!differ) return std::nullopt;
  fit.line.slope = product / fit.spread;
  fit.line.intercept = mean_y - fit.line.slope * fit.mean_x;
  return fit;
}

void set_errors(WeightedLine& fit, double variance) {
  fit.line.slope_error = std::sqrt(variance / fit.spread);
  fit.line.intercept_error =
      std::sqrt(variance * (1 / fit.sum + fit.mean_x * fit.mean_x / fit.spread));
}

}  // namespace

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
  std::optional<WeightedLine> fit = weighted_line(x, y, std::vector<double>(x.size(), 1.0));
  if (!fit) return std::nullopt;
  if (x.size() < 3) return fit->line;
  double squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double residual = y[k] - fit->line.intercept - fit->line.slope * x[k];
    squares += residual * residual;
  }
  set_errors(*fit, squares / static_cast<double>(x.size() - 2));
  return fit->line;
}

std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y,
                             std::span<const double> errors) {
  std::vector<double> weights;
  for (const double error : errors) weights.push_back(1 / (error * error));
  std::optional<WeightedLine> fit = weighted_line(x, y, weights);
  if (!fit) return std::nullopt;
  set_errors(*fit, 1);
  return fit->line;
}

}  // namespace quicksand
