// Diameters of deposited grains: a normal distribution about 1 d, cut on both sides alike, so that the
// mean stays 1 d. What is given is the standard deviation of the cut distribution.
#pragma once

#include "core/base/random.h"

namespace quicksand {

constexpr double kLeastDiameter = 0.2, kMostDiameter = 1.8;  // [d]
// A cut distribution cannot be as wide as the uniform one between the cuts, 0.46 d. [d]
constexpr double kMostDeviation = 0.4;

// Standard deviation of the normal distribution that has `deviation` after the cut, up to
// kMostDeviation [d].
double deviation_before_cut(double deviation);

// A diameter, given the standard deviation before the cut [d]. Draws pairs of numbers until it is
// between the cuts.
double draw_diameter(Random& random, double before_cut);

}  // namespace quicksand
