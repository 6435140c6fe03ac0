// Means and straight lines through measured values, with their standard errors.
//
// Mean of n values: m = sum y / n, error sqrt(sum (y - m)^2 / (n (n - 1))).
// Line y = a + b x with weights w, X = sum w x / sum w, S = sum w (x - X)^2:
//   b = sum w (x - X) y / S,  a = sum w y / sum w - b X,
//   var b = v / S,  var a = v (1/sum w + X^2/S).
// Ordinary: w = 1, and v = sum (y - a - b x)^2 / (n - 2) is the scatter about the line. Weighted by
// known errors e of the values: w = 1/e^2 and v = 1, so that the errors do not depend on the scatter.
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
  std::optional<double> slope_error = {};  // empty for an ordinary line through two points
  std::optional<double> intercept_error = {};
};
// x and y have the same length (n). Empty unless two x differ.
std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y);
// The same with the standard errors of y, (n), all above 0.
std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y,
                             std::span<const double> errors);

}  // namespace quicksand
