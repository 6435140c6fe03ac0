// Solves a tiny contact problem by trying every combination of contact statuses: the reference of the
// solvers that shares no idea with them.
#pragma once

#include "core/problem/contact_problem.h"

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

// All isolated solutions: one for each combination of modes that obeys every law to rounding. With
// friction there may be several.
struct Reference {
  std::vector<ReferenceSolution> solutions;
  // False if a combination had singular but solvable equations (redundant contacts): then there may be
  // whole lines of solutions besides. They exist: the rolling friction of a wedged disk depends on
  // how hard it is wedged, which the laws leave open, and so does its spin.
  bool complete = true;
};
Reference reference_solutions(const ContactProblem& problem);

// Worst violation of the contact laws by these impulses, in impulse or velocity, in the words of the
// laws and not of any residual.
double law_violation(const ContactProblem& problem, const std::vector<Vec3>& impulse);

// Distance of a velocity from the nearest of the solutions.
double distance_to_nearest(const std::vector<ReferenceSolution>& solutions,
                           const std::vector<Vec3>& velocity);

}  // namespace quicksand
