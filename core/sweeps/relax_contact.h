// One contact solved against the present velocities of its two bodies, the step of Gauss-Seidel methods.
#pragma once

#include <vector>

#include "core/problem/contact_problem.h"
#include "core/problem/delassus.h"
#include "core/problem/projection.h"

namespace quicksand {

// inverse_delassus of each contact (nc).
inline void inverse_delassus(const ContactProblem& problem, std::vector<Vec3>& inverse) {
  inverse.clear();
  inverse.reserve(problem.contacts.size());
  for (const ContactRow& row : problem.contacts) inverse.push_back(inverse_delassus(problem, row));
}

// N, then R_t, then T, as far as the first `Components` of them are modelled, each exactly. `inv` is the
// contact's inverse_delassus; the velocities follow its impulse.
template <int Components>
void relax_contact(const ContactProblem& problem, std::size_t c, const Vec3& inv,
                   ContactState& state) {
  const ContactRow& row = problem.contacts[c];
  Vec3& va = state.velocity[row.a];
  Vec3& vb = state.velocity[row.b];
  const Vec3& ima = problem.inverse_mass[row.a];
  const Vec3& imb = problem.inverse_mass[row.b];
  Vec3& p = state.impulse[c];

  const Vec2 n = row.normal;
  const Vec2 t = perpendicular(n);
  double u_n = row.offset.x() + n.dot(vb.head<2>() - va.head<2>());
  if constexpr (Components >= 2) u_n += row.spin_b.x() * vb.z() - row.spin_a.x() * va.z();
  const double new_n = project_normal(p.x() - u_n * inv.x());
  const double dn = new_n - p.x();
  p.x() = new_n;
  va.head<2>() -= dn * ima.head<2>().cwiseProduct(n);
  vb.head<2>() += dn * imb.head<2>().cwiseProduct(n);

  if constexpr (Components >= 2) {
    va.z() -= dn * row.spin_a.x() * ima.z();
    vb.z() += dn * row.spin_b.x() * imb.z();
    const double u_t = row.offset.y() + t.dot(vb.head<2>() - va.head<2>()) +
                       row.spin_b.y() * vb.z() - row.spin_a.y() * va.z();
    const double new_t = project_bounded(p.y() - u_t * inv.y(), row.friction * new_n);
    const double d = new_t - p.y();
    p.y() = new_t;
    va.head<2>() -= d * ima.head<2>().cwiseProduct(t);
    vb.head<2>() += d * imb.head<2>().cwiseProduct(t);
    va.z() -= d * row.spin_a.y() * ima.z();
    vb.z() += d * row.spin_b.y() * imb.z();
  }
  if constexpr (Components >= 3) {
    const double w = row.offset.z() + vb.z() - va.z();
    const double new_r = project_bounded(p.z() - w * inv.z(), row.rolling * new_n);
    const double d = new_r - p.z();
    p.z() = new_r;
    va.z() -= d * ima.z();
    vb.z() += d * imb.z();
  }
}

// work.operator()<Components>() for as many components as the problem has.
template <class Work>
void with_components(const ContactProblem& problem, Work work) {
  switch (problem.components) {
    case 1:
      return work.template operator()<1>();
    case 2:
      return work.template operator()<2>();
    default:
      return work.template operator()<3>();
  }
}

}  // namespace quicksand
