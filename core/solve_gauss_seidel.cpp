#include "core/solve_gauss_seidel.h"

#include <algorithm>

#include "core/delassus.h"
#include "core/residual.h"

namespace quicksand {

namespace {

// Judging a state costs about a sweep.
constexpr int kSweepsBetweenJudgements = 20;

// One sweep with the first `Components` of (N, R_t, T) modelled.
template <int Components>
void sweep(const ContactProblem& problem, const std::vector<Vec3>& inverse_delassus,
           ContactState& state) {
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    Vec3& va = state.velocity[row.a];
    Vec3& vb = state.velocity[row.b];
    const Vec3& ima = problem.inverse_mass[row.a];
    const Vec3& imb = problem.inverse_mass[row.b];
    Vec3& p = state.impulse[c];
    const Vec3& inv = inverse_delassus[c];

    const Vec2 n = row.normal;
    const Vec2 t = perpendicular(n);
    double u_n = row.offset.x() + n.dot(vb.head<2>() - va.head<2>());
    if constexpr (Components >= 2) u_n += row.spin_b.x() * vb.z() - row.spin_a.x() * va.z();
    const double new_n = std::max(0.0, p.x() - u_n * inv.x());
    const double dn = new_n - p.x();
    p.x() = new_n;
    va.head<2>() -= dn * ima.head<2>().cwiseProduct(n);
    vb.head<2>() += dn * imb.head<2>().cwiseProduct(n);

    if constexpr (Components >= 2) {
      va.z() -= dn * row.spin_a.x() * ima.z();
      vb.z() += dn * row.spin_b.x() * imb.z();
      const double u_t = row.offset.y() + t.dot(vb.head<2>() - va.head<2>()) +
                         row.spin_b.y() * vb.z() - row.spin_a.y() * va.z();
      const double bound = row.friction * new_n;
      const double new_t = std::clamp(p.y() - u_t * inv.y(), -bound, bound);
      const double d = new_t - p.y();
      p.y() = new_t;
      va.head<2>() -= d * ima.head<2>().cwiseProduct(t);
      vb.head<2>() += d * imb.head<2>().cwiseProduct(t);
      va.z() -= d * row.spin_a.y() * ima.z();
      vb.z() += d * row.spin_b.y() * imb.z();
    }
    if constexpr (Components >= 3) {
      const double bound = row.rolling * new_n;
      const double new_r =
          std::clamp(p.z() - (row.offset.z() + vb.z() - va.z()) * inv.z(), -bound, bound);
      const double d = new_r - p.z();
      p.z() = new_r;
      va.z() -= d * ima.z();
      vb.z() += d * imb.z();
    }
  }
}

}  // namespace

SolveReport solve_gauss_seidel(const ContactProblem& problem, const SolverSettings& settings,
                               ContactState& state) {
  std::vector<Vec3> inverse_delassus(problem.contacts.size());
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    inverse_delassus[c] = inverse_or_zero(
        delassus_diagonal(row, problem.inverse_mass[row.a], problem.inverse_mass[row.b]));
  }

  SolveReport report;
  const auto judge = [&] {
    report.residual = residual(problem, state);
    report.converged = settings.accepts(report.residual);
    return report.converged;
  };
  judge();
  if (!report.converged) report.rung = Rung::polish;
  while (!report.converged && report.iterations < settings.max_iterations) {
    const auto sweeps = std::min<std::int64_t>(kSweepsBetweenJudgements,
                                               settings.max_iterations - report.iterations);
    for (std::int64_t k = 0; k < sweeps; ++k) {
      switch (problem.components) {
        case 1:
          sweep<1>(problem, inverse_delassus, state);
          break;
        case 2:
          sweep<2>(problem, inverse_delassus, state);
          break;
        default:
          sweep<3>(problem, inverse_delassus, state);
          break;
      }
    }
    report.iterations += sweeps;
    judge();
  }
  return report;
}

}  // namespace quicksand
