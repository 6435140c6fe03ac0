// What grain units are in SI, for a scene that gives physical values.
//
// A grain is read as a sphere of diameter d for its mass: m = density pi/6 d^3. Then F_g = m g, time
// sqrt(d/g), velocity sqrt(g d), energy F_g d.
#pragma once

#include <string>

#include "core/scene/scenario.h"

namespace quicksand {

struct SiScale {
  double length = 0;    // d [m]
  double mass = 0;      // m [kg]
  double time = 0;      // sqrt(d/g) [s]
  double velocity = 0;  // sqrt(g d) [m/s]
  double force = 0;     // F_g [N]
  double energy = 0;    // F_g d [J]
};

SiScale si_scale(const PhysicalScale& physical);

constexpr double kKilopascals = 1e-3;  // in a pascal [kPa/Pa]

// A value with the prefix that keeps it between 1 and 1000: `12.3 um`. `unit` without prefix; a mass
// is given in g.
std::string with_prefix(double value, const std::string& unit);

}  // namespace quicksand
