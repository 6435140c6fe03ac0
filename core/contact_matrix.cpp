#include "core/contact_matrix.h"

#include "core/parallel.h"

namespace quicksand {

namespace {

// Rows n, t, r of H for the two bodies: u = of_a v_a + of_b v_b. Directions in which a body cannot
// move are left out.
struct Jacobian {
  Mat3 of_a, of_b;
};

Jacobian jacobian(const ContactRow& c, const Vec3& ima, const Vec3& imb) {
  const Vec2 n = c.normal, t = perpendicular(c.normal);
  Jacobian h;
  h.of_a << -n.x(), -n.y(), -c.spin_a.x(), -t.x(), -t.y(), -c.spin_a.y(), 0, 0, -1;
  h.of_b << n.x(), n.y(), c.spin_b.x(), t.x(), t.y(), c.spin_b.y(), 0, 0, 1;
  for (int k = 0; k < 3; ++k) {
    if (ima[k] == 0) h.of_a.col(k).setZero();
    if (imb[k] == 0) h.of_b.col(k).setZero();
  }
  return h;
}

// D h, in which only the first column and the diagonal of D are not zero (see interior_point_cone.h).
[[gnu::always_inline]] inline Mat3 answer(const Mat3& d, const Mat3& h) {
  Mat3 result;
  for (int k = 0; k < 3; ++k) {
    result(0, k) = d(0, 0) * h(0, k);
    result(1, k) = d(1, 0) * h(0, k) + d(1, 1) * h(1, k);
    result(2, k) = d(2, 0) * h(0, k) + d(2, 2) * h(2, k);
  }
  return result;
}

// sum += h^T b. Spelled out: for Eigen's product the compiler makes a call.
[[gnu::always_inline]] inline void add_product(const Mat3& h, const Mat3& b, BlockLu::Entry sum) {
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      sum(i, k) += h(0, i) * b(0, k) + h(1, i) * b(1, k) + h(2, i) * b(2, k);
}

}  // namespace

void ContactMatrix::attach(const ContactProblem& problem) {
  problem_ = &problem;
  body_of_row_.clear();
  row_of_body_.assign(problem.inverse_mass.size(), -1);
  for (std::size_t i = 0; i < problem.inverse_mass.size(); ++i) {
    if (problem.inverse_mass[i].isZero(0)) continue;
    row_of_body_[i] = static_cast<int>(body_of_row_.size());
    body_of_row_.push_back(static_cast<int>(i));
  }
  edges_.clear();
  edge_of_contact_.assign(problem.contacts.size(), -1);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const int i = row_of_body_[problem.contacts[c].a], j = row_of_body_[problem.contacts[c].b];
    if (i < 0 || j < 0) continue;
    edge_of_contact_[c] = static_cast<int>(edges_.size());
    edges_.push_back({i, j});
  }
  lu_.analyse(static_cast<int>(body_of_row_.size()), edges_);
}

void ContactMatrix::factorise(const std::vector<Mat3>& stiffness) {
  const ContactProblem& problem = *problem_;
  lu_.clear();
  for (std::size_t k = 0; k < body_of_row_.size(); ++k) {
    const Vec3& im = problem.inverse_mass[body_of_row_[k]];
    for (int d = 0; d < 3; ++d) lu_.diagonal(static_cast<int>(k))(d, d) = im[d] > 0 ? 1 / im[d] : 1;
  }
  visit_sides(
      problem,
      [&](std::size_t c, const ContactRow& row) {
        const Jacobian h = jacobian(row, problem.inverse_mass[row.a], problem.inverse_mass[row.b]);
        const int i = row_of_body_[row.a], e = edge_of_contact_[c];
        const Mat3 da = answer(stiffness[c], h.of_a);
        if (i >= 0) add_product(h.of_a, da, lu_.diagonal(i));
        if (e >= 0) add_product(h.of_b, da, lu_.lower(e));
      },
      [&](std::size_t c, const ContactRow& row) {
        const Jacobian h = jacobian(row, problem.inverse_mass[row.a], problem.inverse_mass[row.b]);
        const int j = row_of_body_[row.b], e = edge_of_contact_[c];
        const Mat3 db = answer(stiffness[c], h.of_b);
        if (j >= 0) add_product(h.of_b, db, lu_.diagonal(j));
        if (e >= 0) add_product(h.of_a, db, lu_.upper(e));
      });
  lu_.factorise();
}

void ContactMatrix::velocity_change(const std::vector<Vec3>& impulse, std::vector<Vec3>& dv) {
  const ContactProblem& problem = *problem_;
  dv.assign(problem.inverse_mass.size(), Vec3::Zero());
  visit_sides(
      problem,
      [&](std::size_t c, const ContactRow& row) { dv[row.a] += momentum_of_a(row, impulse[c]); },
      [&](std::size_t c, const ContactRow& row) { dv[row.b] += momentum_of_b(row, impulse[c]); });
  right_hand_side_.resize(body_of_row_.size());
  for (std::size_t k = 0; k < body_of_row_.size(); ++k) {
    const int i = body_of_row_[k];
    for (int d = 0; d < 3; ++d)
      right_hand_side_[k][d] = problem.inverse_mass[i][d] > 0 ? dv[i][d] : 0;
  }
  lu_.solve(right_hand_side_);
  for (std::size_t i = 0; i < dv.size(); ++i) {
    const int k = row_of_body_[i];
    dv[i] = k < 0 ? Vec3(0, 0, 0) : right_hand_side_[static_cast<std::size_t>(k)];
  }
}

}  // namespace quicksand
