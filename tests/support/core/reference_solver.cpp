#include "tests/support/core/reference_solver.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace quicksand {

namespace {

constexpr double kSlack = 1e-9;     // inequalities hold up to this, impulses over the largest
constexpr double kSingular = 1e-9;  // smallest pivot over the largest

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// Relative velocities of all contacts are u = u_free + W p, in blocks of (u_n, u_t, w).
struct Dense {
  Matrix operator_;
  Vector free;
};

// Rows of the relative velocity of one contact by the velocity of a and of b, from their definition.
void jacobian(const ContactRow& c, Eigen::Matrix3d& of_a, Eigen::Matrix3d& of_b) {
  const double nx = c.normal.x(), ny = c.normal.y();
  of_b << nx, ny, c.spin_b.x(), -ny, nx, c.spin_b.y(), 0, 0, 1;
  of_a << -nx, -ny, -c.spin_a.x(), ny, -nx, -c.spin_a.y(), 0, 0, -1;
}

Dense assemble(const ContactProblem& problem) {
  const auto nb = static_cast<Eigen::Index>(problem.inverse_mass.size());
  const auto nc = static_cast<Eigen::Index>(problem.contacts.size());
  Matrix h = Matrix::Zero(3 * nc, 3 * nb);
  Vector v(3 * nb);
  Matrix inverse_mass = Matrix::Zero(3 * nb, 3 * nb);
  for (Eigen::Index i = 0; i < nb; ++i) {
    v.segment<3>(3 * i) = problem.free_velocity[static_cast<std::size_t>(i)];
    inverse_mass.diagonal().segment<3>(3 * i) = problem.inverse_mass[static_cast<std::size_t>(i)];
  }
  for (Eigen::Index c = 0; c < nc; ++c) {
    const ContactRow& row = problem.contacts[static_cast<std::size_t>(c)];
    Eigen::Matrix3d of_a, of_b;
    jacobian(row, of_a, of_b);
    h.block<3, 3>(3 * c, 3 * row.a) = of_a;
    h.block<3, 3>(3 * c, 3 * row.b) = of_b;
  }
  Vector free = h * v;
  for (Eigen::Index c = 0; c < nc; ++c)
    free.segment<3>(3 * c) += problem.contacts[static_cast<std::size_t>(c)].offset;
  return {h * inverse_mass * h.transpose(), free};
}

// Every mode of a contact: 1 + 3 * 3 with rolling friction, 1 + 3 with friction, 2 without.
std::vector<Mode> modes_of_a_contact(int components) {
  using enum Sign;
  const std::vector<Sign> all{negative, stuck, positive}, none{stuck};
  std::vector<Mode> modes{{}};
  for (Sign slip : components >= 2 ? all : none)
    for (Sign roll : components >= 3 ? all : none)
      modes.push_back({.closed = true, .slip = slip, .roll = roll});
  return modes;
}

// The impulses that the equations of these modes give. If the equations are singular there are none,
// and `complete` becomes false if they could be solved nevertheless.
std::optional<Vector> impulses(const ContactProblem& problem, const Dense& dense,
                               const std::vector<Mode>& modes, bool& complete) {
  const Eigen::Index size = dense.free.size();
  Matrix a = Matrix::Identity(size, size);  // rows that stay say: this impulse is zero
  Vector rhs = Vector::Zero(size);
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (!modes[c].closed) continue;
    const ContactRow& row = problem.contacts[c];
    const auto n = static_cast<Eigen::Index>(3 * c);
    a.row(n) = dense.operator_.row(n);
    rhs[n] = -dense.free[n];
    const auto bounded = [&](Eigen::Index k, Sign sign, double bound) {
      if (sign == Sign::stuck) {
        a.row(k) = dense.operator_.row(k);
        rhs[k] = -dense.free[k];
      } else {
        a(k, n) = -static_cast<double>(sign) * bound;
      }
    };
    if (problem.components >= 2) bounded(n + 1, modes[c].slip, row.friction);
    if (problem.components >= 3) bounded(n + 2, modes[c].roll, row.rolling);
  }
  // Impulses count over the square root of the mass that they meet, so that pivots are comparable
  // whatever the masses.
  Vector unit = Vector::Ones(size);
  for (Eigen::Index k = 0; k < size; ++k)
    if (dense.operator_(k, k) > 0) unit[k] = 1 / std::sqrt(dense.operator_(k, k));
  for (Eigen::Index k = 0; k < size; ++k) {
    const bool is_velocity = a.row(k) == dense.operator_.row(k);
    const double by = is_velocity ? unit[k] : 1 / unit[k];
    a.row(k) *= by;
    rhs[k] *= by;
  }
  a *= unit.asDiagonal();
  const Eigen::FullPivLU<Matrix> lu(a);
  const auto pivots = lu.matrixLU().diagonal().cwiseAbs();
  const Vector p = lu.solve(rhs);
  if (pivots.minCoeff() >= kSingular * pivots.maxCoeff()) return unit.cwiseProduct(p);
  if ((a * p - rhs).norm() <= kSlack * std::max(1.0, rhs.norm())) complete = false;
  return {};
}

// Whether the inequalities of the modes hold.
bool lawful(const ContactProblem& problem, const std::vector<Mode>& modes, const Vector& p,
            const Vector& u) {
  const double slack = kSlack * std::max(1.0, p.cwiseAbs().maxCoeff());  // of impulses
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    const auto n = static_cast<Eigen::Index>(3 * c);
    if (u[n] < -kSlack || p[n] < -slack) return false;
    const auto obeys = [&](Eigen::Index k, Sign sign, double bound) {
      if (!modes[c].closed) return true;
      if (sign == Sign::stuck) return std::abs(p[k]) <= bound * p[n] + slack;
      return u[k] * static_cast<double>(sign) <= kSlack;  // against the slip
    };
    if (problem.components >= 2 && !obeys(n + 1, modes[c].slip, row.friction)) return false;
    if (problem.components >= 3 && !obeys(n + 2, modes[c].roll, row.rolling)) return false;
  }
  return true;
}

ReferenceSolution solution(const ContactProblem& problem, const std::vector<Mode>& modes,
                           const Vector& p) {
  ReferenceSolution s{.velocity = problem.free_velocity, .impulse = {}, .modes = modes};
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    const Vec3 impulse = p.segment<3>(static_cast<Eigen::Index>(3 * c));
    Eigen::Matrix3d of_a, of_b;
    jacobian(row, of_a, of_b);
    const auto a = static_cast<std::size_t>(row.a), b = static_cast<std::size_t>(row.b);
    s.velocity[a] += problem.inverse_mass[a].cwiseProduct(of_a.transpose() * impulse);
    s.velocity[b] += problem.inverse_mass[b].cwiseProduct(of_b.transpose() * impulse);
    s.impulse.push_back(impulse);
  }
  return s;
}

}  // namespace

Reference reference_solutions(const ContactProblem& problem) {
  const Dense dense = assemble(problem);
  const std::vector<Mode> choices = modes_of_a_contact(problem.components);
  std::vector<std::size_t> choice(problem.contacts.size(), 0);
  std::vector<Mode> modes(problem.contacts.size());
  Reference reference;
  for (;;) {
    for (std::size_t c = 0; c < modes.size(); ++c) modes[c] = choices[choice[c]];
    if (const auto p = impulses(problem, dense, modes, reference.complete)) {
      const Vector u = dense.free + dense.operator_ * *p;
      if (lawful(problem, modes, *p, u))
        reference.solutions.push_back(solution(problem, modes, *p));
    }
    // Counts through all combinations like an odometer.
    std::size_t digit = 0;
    while (digit < choice.size() && ++choice[digit] == choices.size()) choice[digit++] = 0;
    if (digit == choice.size()) return reference;
  }
}

double law_violation(const ContactProblem& problem, const std::vector<Vec3>& impulse) {
  const Dense dense = assemble(problem);
  Vector p(dense.free.size());
  for (std::size_t c = 0; c < impulse.size(); ++c)
    p.segment<3>(static_cast<Eigen::Index>(3 * c)) = impulse[c];
  const Vector u = dense.free + dense.operator_ * p;
  double worst = 0;
  for (std::size_t c = 0; c < impulse.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    const auto n = static_cast<Eigen::Index>(3 * c);
    worst = std::max(worst, std::abs(std::min(p[n], u[n])));
    const auto dry = [&](Eigen::Index k, double bound) {
      const double outside = std::abs(p[k]) - bound;
      const double not_opposite = std::abs(p[k] + std::copysign(bound, u[k]));
      worst = std::max({worst, outside, std::min(std::abs(u[k]), not_opposite)});
    };
    if (problem.components >= 2) dry(n + 1, row.friction * p[n]);
    if (problem.components >= 3) dry(n + 2, row.rolling * p[n]);
  }
  return worst;
}

double distance_to_nearest(const std::vector<ReferenceSolution>& solutions,
                           const std::vector<Vec3>& velocity) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const ReferenceSolution& s : solutions) {
    double worst = 0;
    for (std::size_t i = 0; i < velocity.size(); ++i)
      worst = std::max(worst, (s.velocity[i] - velocity[i]).norm());
    nearest = std::min(nearest, worst);
  }
  return nearest;
}

}  // namespace quicksand
