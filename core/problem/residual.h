// The one residual that measures every solver.
//
// Of each contact the largest component of its natural map counts (projection.h), that of T over the mean arm; all
// vanish exactly at a solution.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/problem/contact_problem.h"
#include "core/problem/projection.h"

namespace quicksand {

// Distance of a state from the contact laws; see residual.h.
struct Residual {
  double natural = 0;  // worst projection residual over force_scale dt [1]
  double gap = 0;  // worst |gap error| over gap_tolerance where N > 0, or where bodies overlap [1]
};

// The largest of the three of one contact with impulse p and relative velocity u = H v + offset, given
// its inverse_delassus. [impulse]
inline double contact_residual(const ContactProblem& problem, const ContactRow& row,
                               const Vec3& step, const Vec3& p, const Vec3& u) {
  const Vec3 off = natural_map(row, problem.components, p, p - u.cwiseProduct(step));
  return std::max({std::abs(off.x()), std::abs(off.y()), std::abs(off.z()) / row.arm});
}

// Measures the impulses. The velocities are set to those that the impulses give, so that no solver can
// mislead by velocities that do not belong to its impulses. Infinite if anything is not finite. Where the worst is of
// interest only up to `most`, part of the contacts may do to know that it is beyond: it is at least what is returned.
Residual residual(const ContactProblem& problem, ContactState& state,
                  const Residual& most = {.natural = std::numeric_limits<double>::infinity(),
                                          .gap = std::numeric_limits<double>::infinity()});

// Velocity that the impulses give (nb).
void velocity_from_impulses(const ContactProblem& problem, const std::vector<Vec3>& impulse,
                            std::vector<Vec3>& velocity);

}  // namespace quicksand
