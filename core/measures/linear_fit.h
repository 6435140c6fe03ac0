// Means and straight lines through measured values, with their standard errors.
//
// Mean of n values: m = sum y / n, error sqrt(sum (y - m)^2 / (n (n - 1))).
// Line y = a + b x through n points, X = sum x / n, S = sum (x - X)^2:
//   b = sum (x - X) y / S,  a = sum y / n - b X,
//   var b = v / S,  var a = v (1/n + X^2/S),  v = sum (y - a - b x)^2 / (n - 2).
// [Bevington 2003, chapter 6]
#pragma once

#include <optional>
#include <span>

namespace quicksand {

struct Mean {
  double value = 0;
  std::optional<double> error = {};  // empty for a single value
};
// Empty if there are no values.
std::optional<Mean> mean_of(std::span<const double> values);

struct Line {
  double slope = 0;
  double intercept = 0;
  std::optional<double> slope_error = {};  // empty for a line through two points
  std::optional<double> intercept_error = {};
};
// x and y have the same length (n). Empty unless two x differ.
std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y);
// What known errors of the y (n) make of the slope: sqrt(sum ((x - X) error)^2) / S. There must be such a line.
double slope_error_by(std::span<const double> x, std::span<const double> y_error);

}  // namespace quicksand
