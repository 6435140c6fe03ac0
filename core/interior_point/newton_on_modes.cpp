#include "core/interior_point/newton_on_modes.h"

#include <cmath>

#include "core/base/memory.h"
#include "core/problem/delassus.h"
#include "core/problem/residual.h"

namespace quicksand {

namespace {

constexpr double kModesProximal = 1e-8;  // eps
// No further factorisation where velocities changed by less than this share of the tolerance.
constexpr double kSettled = 1e-2;

}  // namespace

Status NewtonOnModes::read_bounded(std::size_t contact, int component, double limit, const Vec3& p,
                                   const Vec3& q, const Vec3& u, const Vec3& w) {
  if (w[component] <= 0) return Status::open;
  Vec3& change = change_[contact];
  Impedance<double>& impedance = impedance_[contact];
  double& own = component == 1 ? impedance.tt : impedance.rr;
  double& by_normal = component == 1 ? impedance.tn : impedance.rn;
  const Status status = status_of_bounded(q[component], limit * q.x());
  if (status == Status::held) {
    change[component] = -u[component] / (kModesProximal * w[component]);
    own = 1 / (kModesProximal * w[component]);
  } else {
    const double slope = status == Status::at_upper_bound ? limit : -limit;
    change[component] = slope * (p.x() + change.x()) - p[component];
    by_normal = slope * impedance.nn;
  }
  return status;
}

bool NewtonOnModes::read_modes(const ContactProblem& problem, const ContactState& state) {
  const std::size_t nc = problem.contacts.size();
  bool same = modes_.size() == nc;
  set_size(modes_, nc);
  set_size(impedance_, nc);
  set_size(change_, nc);
  for (std::size_t c = 0; c < nc; ++c) {
    const ContactRow& row = problem.contacts[c];
    const Vec3 w = delassus_diagonal(row, problem.inverse_mass[row.a], problem.inverse_mass[row.b]);
    const Vec3 u =
        row.offset + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
    const Vec3& p = state.impulse[c];
    Modes modes;
    impedance_[c] = {};
    change_[c] = -p;
    const Vec3 q = p - u.cwiseQuotient(w);
    modes.normal = status_of_normal(q.x());
    if (modes.normal == Status::held) {
      change_[c] = {-u.x() / (kModesProximal * w.x()), 0, 0};
      impedance_[c].nn = 1 / (kModesProximal * w.x());
      if (problem.components >= 2) modes.slide = read_bounded(c, 1, row.friction, p, q, u, w);
      if (problem.components >= 3) modes.roll = read_bounded(c, 2, row.rolling, p, q, u, w);
    }
    same = same && modes == modes_[c];
    modes_[c] = modes;
  }
  return same;
}

SolveReport NewtonOnModes::solve(const ContactProblem& problem, const SolverSettings& settings,
                                 int max_iterations, ContactMatrix& matrix, ContactState& state) {
  SolveReport report;
  report.residual = residual(problem, state);
  modes_.clear();
  best_ = state;
  bool from_best = true, settled = false;
  for (int k = 0; k < max_iterations; ++k) {
    if (!read_modes(problem, state)) {
      if (settled) break;
      matrix.factorise(impedance_);
      ++report.factorisations;
    }
    matrix.velocity_change(change_, dv_);
    for (std::size_t c = 0; c < change_.size(); ++c) {
      const ContactRow& row = problem.contacts[c];
      state.impulse[c] +=
          change_[c] - impedance_[c] * relative_velocity(row, dv_[row.a], dv_[row.b]);
    }
    const double change = matrix.fastest_change() / problem.velocity_scale;
    if (from_best) report.velocity_change = change;
    const Residual reached = residual(problem, state);
    from_best = settings.distance(reached) < settings.distance(report.residual);
    if (from_best) {
      report.residual = reached;
      best_ = state;
    }
    if (!std::isfinite(change)) break;
    settled = change <= kSettled * settings.velocity_tolerance;
  }
  std::swap(state, best_);
  report.converged = settings.accepts(report.residual);
  return report;
}

}  // namespace quicksand
