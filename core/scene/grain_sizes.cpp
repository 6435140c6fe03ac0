#include "core/scene/grain_sizes.h"

#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

constexpr double kHalfWidth = kMostDiameter - 1;

// Of the normal distribution of standard deviation s cut at +-w, with z = w/s:
// s sqrt(1 - 2 z phi(z)/(2 Phi(z) - 1)).
double deviation_after_cut(double s) {
  const double z = kHalfWidth / s;
  const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
  return s * std::sqrt(1 - 2 * z * density / std::erf(z / std::numbers::sqrt2));
}

}  // namespace

double deviation_before_cut(double deviation) {
  double low = deviation, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (deviation_after_cut(middle) < deviation ? low : high) = middle;
  }
  return high;
}

double draw_diameter(Random& random, double before_cut) {
  for (;;) {
    // Box and Muller's first number; its second would have to be remembered.
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    const double normal = radius * std::cos(2 * std::numbers::pi * random.uniform());
    const double diameter = 1 + before_cut * normal;
    if (diameter >= kLeastDiameter && diameter <= kMostDiameter) return diameter;
  }
}

}  // namespace quicksand
