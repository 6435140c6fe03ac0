// A force that is just enough, as a search has found it.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/types.h"

namespace quicksand {

enum class SearchKind : std::uint8_t { none, pull, shear, adiabatic, push, penetrate, vane };

// Whether it is a critical force.
constexpr bool is_of_force(SearchKind kind) {
  return kind != SearchKind::none && kind != SearchKind::adiabatic;
}

// The smallest force that takes a body out, moves it, or makes it enter; of a vane the smallest torque that turns it
// [F_g d].
struct CriticalForce {
  int phase = 0;  // index
  SearchKind kind = SearchKind::none;
  int body = 0;
  Vec2 position{0, 0};      // in the base, x inside the box [d]
  double depth = 0;         // below the packing top; shear: that of the scene [d]
  double weight_above = 0;  // of all grains whose centres are above that depth [F_g]
  double force_low = 0;     // did not move it in time; 0: every force moved it [F_g]
  double force_held = 0;    // came to rest; below force_low: that trial only ran out of time [F_g]
  std::optional<double> force_high = {};  // moved it; 0: it needed none; empty: no force did [F_g]
  int trials = 0;
  int undecided = 0;  // of these, ended by their time and counted as held

  // Whether the lower end of the interval is a state of rest, and not a trial that only ran out of time.
  bool bracketed() const { return force_held == force_low; }
  bool operator==(const CriticalForce&) const = default;
};

}  // namespace quicksand
