// The tolerances of all tests. The environment variable QUICKSAND_TOLERANCE_SCALE multiplies them, so
// that 0 makes every comparison print its true residual.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace quicksand::tolerance {

inline double scaled(double tolerance) {
  const char* text = std::getenv("QUICKSAND_TOLERANCE_SCALE");
  return text ? tolerance * std::atof(text) : tolerance;
}

// Sums of rounding errors only.
inline double rounding(double magnitude = 1) { return scaled(1e-12 * magnitude); }
// What a solver leaves that converged to kTight.
inline double solved(double magnitude = 1) { return scaled(1e-6 * magnitude); }
// Equilibria that a direct factorisation meets to nearly all digits.
inline double exact(double magnitude = 1) { return scaled(1e-9 * magnitude); }
// A discretised motion against its continuous closed form.
inline double discretised(double magnitude = 1) { return scaled(1e-3 * magnitude); }
// Measured on a finite random sample.
inline double sampled(double magnitude) { return scaled(magnitude); }

// Solver tolerance of tests that compare solutions [1].
constexpr double kTight = 1e-11;

}  // namespace quicksand::tolerance

namespace quicksand {

// Worst component of a difference, NaN if any is.
template <class A, class B>
double distance(const A& a, const B& b) {
  double worst = 0;
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const double d = std::abs(a[k] - b[k]);
    if (std::isnan(d)) return d;
    worst = std::max(worst, d);
  }
  return worst;
}

}  // namespace quicksand
