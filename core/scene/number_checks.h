// Refusals of single numbers of a scene, with their place in it.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "core/base/errors.h"
#include "core/base/types.h"

namespace quicksand {

[[noreturn]] inline void refuse_number(const std::string& path, double x, const char* demand) {
  throw InputError(path, "is " + message_number(x) + "; " + demand);
}

// Where an optional number is absent there is nothing to refuse.
inline void require_positive(const std::string& path, const std::optional<double>& x) {
  if (x && (!(*x > 0) || !std::isfinite(*x)))
    refuse_number(path, *x, "must be positive and finite");
}

inline void require_not_negative(const std::string& path, const std::optional<double>& x) {
  if (x && (!(*x >= 0) || !std::isfinite(*x)))
    refuse_number(path, *x, "must be finite and at least 0");
}

inline void require_finite(const std::string& path, const std::optional<double>& x) {
  if (x && !std::isfinite(*x)) refuse_number(path, *x, "must be finite");
}

template <int n>
void require_finite(const std::string& path, const Eigen::Matrix<double, n, 1>& x) {
  for (const double component : x) require_finite(path, component);
}

inline void require_between(const std::string& path, double x, double low, double high) {
  if (!(x >= low && x <= high))
    refuse_number(path, x,
                  ("must be from " + message_number(low) + " to " + message_number(high)).c_str());
}

}  // namespace quicksand
