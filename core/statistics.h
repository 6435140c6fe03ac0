// Mean and standard error of independent values that count alike.
//
//   mean = sum x_i / n,   standard error = sqrt(sum (x_i - mean)^2 / (n (n - 1)))
#pragma once

#include <optional>
#include <span>

namespace quicksand {

// Needs at least one value.
double mean(std::span<const double> values);

// Of the mean; absent for fewer than two values, which do not tell it.
std::optional<double> standard_error(std::span<const double> values);

}  // namespace quicksand
