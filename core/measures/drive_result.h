// What a driven intruder or piston met: the largest load on the way, and the one that is left.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace quicksand {

enum class Drive : std::uint8_t { penetrate, vane, slide };

// Loads are means in time over windows of the way (see drive.h), forces [F_g] and depths [d] of a penetration, torques [F_g d]
// and angles [rad] of a vane, horizontal forces [F_g] and distances [d] of a piston that slides.
struct DriveResult {
  int phase = 0;  // index
  Drive drive = Drive::penetrate;
  // Largest mean of a window, and the end of that window; none without a step.
  std::optional<double> peak = {}, peak_at = {};
  // Mean in time over the last quarter of the way that was to be; none where it was not reached.
  std::optional<double> residual = {};
  // Over the way: the work against the load, by the way; none where it did not move.
  std::optional<double> mean = {};
  double way = 0;            // in all
  double radius = 0;         // of a vane, to its tips; farthest point of other bodies [d]
  std::int64_t cleared = 0;  // grains that made room
  // Of a piston that slides: the force with which it presses, its weight included [F_g].
  std::optional<double> normal_load = {};
  // ... and speed over height times sqrt(mass of a grain over normal stress), where all of these are known [1].
  std::optional<double> inertial_number = {};

  bool operator==(const DriveResult&) const = default;
};

// Peak over residual; none without a residual, or with one that is rounding.
inline std::optional<double> sensitivity(const DriveResult& found) {
  constexpr double kNegligible = 1e-9;
  if (!found.peak || !found.residual) return std::nullopt;
  if (std::abs(*found.residual) <= kNegligible * std::abs(*found.peak)) return std::nullopt;
  return *found.peak / *found.residual;
}
// Shear strength on the circle of the tips that a torque tells, T/(2 pi R^2) [F_g/d].
inline double vane_strength(double torque, double radius) {
  return torque / (2 * std::numbers::pi * radius * radius);
}

}  // namespace quicksand
