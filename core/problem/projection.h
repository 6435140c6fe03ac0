// The laws of a contact, once: all solvers project on them, and the residual measures the distance from them.
//
// With u = H v + offset and W the diagonal of the contact's own Delassus block, let the trial impulse be
//   q = p - u/W.
// The laws of contact_problem.h hold exactly where p is the projection of q (natural map, [Acary 2018]):
//   N = max(0, q_n),  R_t = q_t kept within +-mu N,  T = q_r kept within +-mu_r N.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/problem/contact_problem.h"

namespace quicksand {

// N of the trial impulse q: a contact pushes and never pulls. [impulse]
inline double project_normal(double q) { return std::max(0.0, q); }

// Friction or rolling friction of the trial impulse q, of at most this size. [impulse]
inline double project_bounded(double q, double bound) {
  return std::min(std::max(q, -bound), bound);
}

// The admissible impulse with the nearest N, and then the nearest R_t and T. [impulse]
inline Vec3 project(const ContactRow& row, const Vec3& p) {
  const double n = project_normal(p.x());
  return {n, project_bounded(p.y(), row.friction * n), project_bounded(p.z(), row.rolling * n)};
}

// p less the projection of the trial impulse q, friction bounded by the N of p; 0 in what is not modelled. It
// vanishes exactly at a solution. [impulse]
inline Vec3 natural_map(const ContactRow& row, int components, const Vec3& p, const Vec3& q) {
  const double n = project_normal(p.x());
  return {p.x() - project_normal(q.x()),
          components >= 2 ? p.y() - project_bounded(q.y(), row.friction * n) : 0,
          components >= 3 ? p.z() - project_bounded(q.z(), row.rolling * n) : 0};
}

// What a law does at a trial impulse: the contact is open, or closed, sticks or holds (then u = 0 in this component),
// or slips at one of its bounds.
enum class Status : std::uint8_t { open, held, at_upper_bound, at_lower_bound };

inline Status status_of_normal(double q) { return q > 0 ? Status::held : Status::open; }
inline Status status_of_bounded(double q, double bound) {
  if (std::abs(q) <= bound) return Status::held;
  return q > 0 ? Status::at_upper_bound : Status::at_lower_bound;
}

}  // namespace quicksand
