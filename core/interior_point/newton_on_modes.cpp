#include "core/interior_point/newton_on_modes.h"

#include <cmath>

#include "core/problem/delassus.h"
#include "core/problem/residual.h"

namespace quicksand {

namespace {

constexpr double kModesProximal = 1e-8;  // eps
// No further factorisation where velocities changed by less than this share of the tolerance.
constexpr double kSettled = 1e-2;

}  // namespace

// One component of friction, bounded by limit N.
void NewtonOnModes::read_bounded(double p, double u, double w, double limit, double q_n, double p_n,
                                 int component, Mode& mode, Vec3& change, Mat3& stiffness) {
  if (w <= 0) return;
  const double q = p - u / w;
  if (std::abs(q) <= limit * q_n) {
    mode = Mode::held;
    change[component] = -u / (kModesProximal * w);
    stiffness(component, component) = 1 / (kModesProximal * w);
    return;
  }
  mode = q > 0 ? Mode::at_upper_bound : Mode::at_lower_bound;
  const double slope = q > 0 ? limit : -limit;
  change[component] = slope * (p_n + change.x()) - p;
  stiffness(component, 0) = slope * stiffness(0, 0);
}

bool NewtonOnModes::read_modes(const ContactProblem& problem, const ContactState& state) {
  const std::size_t nc = problem.contacts.size();
  bool same = modes_.size() == nc;
  modes_.resize(nc);
  stiffness_.resize(nc);
  change_.resize(nc);
  for (std::size_t c = 0; c < nc; ++c) {
    const ContactRow& row = problem.contacts[c];
    const Vec3 w = delassus_diagonal(row, problem.inverse_mass[row.a], problem.inverse_mass[row.b]);
    const Vec3 u =
        row.offset + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
    const Vec3& p = state.impulse[c];
    Modes modes;
    stiffness_[c].setZero();
    change_[c] = -p;
    const double q_n = p.x() - u.x() / w.x();
    if (q_n > 0) {
      modes.normal = Mode::held;
      change_[c] = {-u.x() / (kModesProximal * w.x()), 0, 0};
      stiffness_[c](0, 0) = 1 / (kModesProximal * w.x());
      if (problem.components >= 2)
        read_bounded(p.y(), u.y(), w.y(), row.friction, q_n, p.x(), 1, modes.slide, change_[c],
                     stiffness_[c]);
      if (problem.components >= 3)
        read_bounded(p.z(), u.z(), w.z(), row.rolling, q_n, p.x(), 2, modes.roll, change_[c],
                     stiffness_[c]);
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
      matrix.factorise(stiffness_);
      ++report.factorisations;
    }
    matrix.velocity_change(change_, dv_);
    for (std::size_t c = 0; c < change_.size(); ++c) {
      const ContactRow& row = problem.contacts[c];
      state.impulse[c] +=
          change_[c] - stiffness_[c] * relative_velocity(row, dv_[row.a], dv_[row.b]);
    }
    const double change = fastest_at_contacts(problem, dv_) / problem.velocity_scale;
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
