// Solves a tiny contact problem by trying every combination of contact modes: the judge of the
// solvers that shares no idea with them.
#pragma once

#include <set>

#include "core/solver.h"

namespace quicksand {

enum class Sign : std::int8_t { negative = -1, stuck = 0, positive = 1 };

// Closed contacts slide or stick and roll or stick; `slip` and `roll` are the directions of R_t and T
// at their bounds.
struct Mode {
  bool closed = false;
  Sign slip = Sign::stuck;
  Sign roll = Sign::stuck;
  auto operator<=>(const Mode&) const = default;
};

struct ReferenceSolution {
  std::vector<Vec3> velocity;  // (nb)
  std::vector<Vec3> impulse;   // (nc)
  std::vector<Mode> modes;     // (nc)
};

// All solutions, one for each combination of modes that obeys every law to rounding. Combinations
// whose equations are singular (redundant contacts) are left out, so that the list may miss solutions
// there, but never holds a wrong one. With friction a problem may have several solutions.
std::vector<ReferenceSolution> reference_solutions(const ContactProblem& problem);

// Distance of a velocity from the nearest of the solutions.
double distance_to_nearest(const std::vector<ReferenceSolution>& solutions,
                           const std::vector<Vec3>& velocity);

}  // namespace quicksand
