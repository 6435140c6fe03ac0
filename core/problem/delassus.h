// The diagonal of a contact's own Delassus block W = H M^-1 H^T: how the relative velocity (u_n, u_t,
// w) of the contact answers to its own impulse (N, R_t, T).
#pragma once

#include "core/problem/contact_problem.h"

namespace quicksand {

inline Vec3 delassus_diagonal(const ContactRow& c, const Vec3& ima, const Vec3& imb) {
  const auto along = [](const Vec3& im, const Vec2& n) {
    return im.x() * n.x() * n.x() + im.y() * n.y() * n.y();
  };
  const Vec2 t = perpendicular(c.normal);
  const auto turning = [&](double a, double b) { return a * a * ima.z() + b * b * imb.z(); };
  return {along(ima, c.normal) + along(imb, c.normal) + turning(c.spin_a.x(), c.spin_b.x()),
          along(ima, t) + along(imb, t) + turning(c.spin_a.y(), c.spin_b.y()), ima.z() + imb.z()};
}

// 1 over it, and 0 where a component cannot move.
inline Vec3 inverse_delassus(const ContactProblem& problem, const ContactRow& c) {
  const Vec3 w = delassus_diagonal(c, problem.inverse_mass[c.a], problem.inverse_mass[c.b]);
  return {w.x() > 0 ? 1 / w.x() : 0, w.y() > 0 ? 1 / w.y() : 0, w.z() > 0 ? 1 / w.z() : 0};
}

}  // namespace quicksand
