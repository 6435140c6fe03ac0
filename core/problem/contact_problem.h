// The contact problem of one step: what every solver reads, and the state that it changes.
//
// Unknowns are, for each contact, the impulse (N, R_t, T) on body b, and for each body the velocity
//   v = free_velocity + M^-1 H^T impulse,
// such that with u = (u_n, u_t, w) = H v + offset, the relative velocity of b to a at the contact and
// in n what is left of the gap,
//   0 <= N      complementary to  u_n >= 0
//   |R_t| <= friction N,  opposite to u_t where it slides
//   |T|   <= rolling  N,  opposite to w where it rolls.
// Cohesion is not a solver's business: it enters free_velocity as a known pair of impulses -F_c dt
// along the normal, so that N = R_n + F_c dt. [Kadau 2003]
#pragma once

#include <vector>

#include "core/base/types.h"

namespace quicksand {

struct ContactRow {
  int a = 0;  // body indices into the problem's arrays
  int b = 0;
  Vec2 normal{0, 0};  // unit, from a to b; the tangent is perpendicular(normal)
  Vec2 spin_a{0, 0};  // velocity (normal, tangential) of the contact point of a unit spin of a [d]
  Vec2 spin_b{0, 0};  // and of b; a disk has (0, radius) as a and (0, -radius) as b
  Vec3 offset{0, 0, 0};      // n: gap/dt, and the curvature term of bonded contacts [sqrt(g d)]
  double arm = 1;            // mean radius of the bodies at the contact, the length scale of T [d]
  double friction = 0;       // [1]
  double rolling = 0;        // [d]
  double gap_tolerance = 0;  // admissible |gap error| where N > 0, and overlap [d]
  bool cohesive = false;     // whether free_velocity has an attraction of this contact
};

// Relative velocity H v of b to a at the contact, without the offset.
inline Vec3 relative_velocity(const ContactRow& c, const Vec3& va, const Vec3& vb) {
  const Vec2 dv = vb.head<2>() - va.head<2>();
  return {c.normal.dot(dv) + c.spin_b.x() * vb.z() - c.spin_a.x() * va.z(),
          perpendicular(c.normal).dot(dv) + c.spin_b.y() * vb.z() - c.spin_a.y() * va.z(),
          vb.z() - va.z()};
}

// Transpose of the above: what an impulse (N, R_t, T) does to the momenta of b and of a.
inline Vec3 momentum_of_b(const ContactRow& c, const Vec3& p) {
  const Vec2 f = p.x() * c.normal + p.y() * perpendicular(c.normal);
  return {f.x(), f.y(), p.z() + c.spin_b.dot(p.head<2>())};
}
inline Vec3 momentum_of_a(const ContactRow& c, const Vec3& p) {
  const Vec2 f = p.x() * c.normal + p.y() * perpendicular(c.normal);
  return {-f.x(), -f.y(), -p.z() - c.spin_a.dot(p.head<2>())};
}

// Built once a step, constant while solving.
struct ContactProblem {
  double dt = 0;              // [sqrt(d/g)]
  double force_scale = 1;     // forces are measured relative to this [F_g]
  double velocity_scale = 1;  // and velocities relative to this [sqrt(g d)]
  int components = 3;  // modelled: 1 normal (of disks), 2 and friction, 3 and rolling friction
  std::vector<Vec3> inverse_mass;    // (nb) (1/m, 1/m, 1/I)
  std::vector<Vec3> free_velocity;   // (nb) velocity at the end of the step without contacts
  std::vector<ContactRow> contacts;  // (nc)
};

struct ContactState {
  std::vector<Vec3> velocity;  // (nb)
  std::vector<Vec3> impulse;   // (nc); on entry the warm start
};

}  // namespace quicksand
