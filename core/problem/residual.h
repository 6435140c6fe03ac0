// The one judge of every solver.
//
// For each contact, with W the diagonal of its own Delassus block and u = H v + offset,
//   r_n = |N   - max(0, N - u_n/W_n)|
//   r_t = |R_t - clamp(R_t - u_t/W_t, -mu N, mu N)|
//   r_r = |T   - clamp(T   - w/W_r,   -mu_r N, mu_r N)| / r,  r the mean arm,
// which all vanish exactly at a solution (natural map, [Acary 2018]).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/problem/contact_problem.h"
#include "core/problem/delassus.h"

namespace quicksand {

// Distance of a state from the contact laws; see residual.h.
struct Residual {
  double natural = 0;  // worst projection residual over force_scale dt [1]
  double gap = 0;      // worst |gap error| over gap_tolerance where N > 0 [1]
};

// The largest of the three of one contact with impulse p and relative velocity u = H v + offset, given
// its inverse_delassus. [impulse]
inline double contact_residual(const ContactProblem& problem, const ContactRow& row,
                               const Vec3& step, const Vec3& p, const Vec3& u) {
  double r = std::abs(p.x() - std::max(0.0, p.x() - u.x() * step.x()));
  const double n = std::max(0.0, p.x());
  if (problem.components >= 2) {
    const double bound = row.friction * n;
    r = std::max(r, std::abs(p.y() - std::clamp(p.y() - u.y() * step.y(), -bound, bound)));
  }
  if (problem.components >= 3) {
    const double bound = row.rolling * n;
    r = std::max(r,
                 std::abs(p.z() - std::clamp(p.z() - u.z() * step.z(), -bound, bound)) / row.arm);
  }
  return r;
}

// Judges the impulses. The velocities are set to those that the impulses give, so that no solver can
// mislead by velocities that do not belong to its impulses. Infinite if anything is not finite.
Residual residual(const ContactProblem& problem, ContactState& state);

// Velocity that the impulses give (nb).
void velocity_from_impulses(const ContactProblem& problem, const std::vector<Vec3>& impulse,
                            std::vector<Vec3>& velocity);

// Fastest at a contact of a change of velocity (nb) there, turning included. [sqrt(g d)]
double fastest_at_contacts(const ContactProblem& problem, const std::vector<Vec3>& change);

}  // namespace quicksand
