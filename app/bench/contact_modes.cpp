#include "app/bench/contact_modes.h"

#include <algorithm>
#include <cmath>

#include "core/contact_matrix.h"
#include "core/delassus.h"
#include "core/residual.h"

namespace quicksand::bench {

namespace {

constexpr int kIterations = 40;
constexpr double kProximal = 1e-6;  // eps

// One component of friction with this bound on p = (p_n, p_t): change r - D u that its mode demands.
void tangential(double p, double u, double w, double limit, double q_n, double p_n, int component,
                Vec3& r, Mat3& d) {
  if (w <= 0) return;
  const double bound = limit * q_n;
  const double q = p - u / w;
  if (std::abs(q) <= bound) {
    r[component] = -u / (kProximal * w);
    d(component, component) = 1 / (kProximal * w);
    return;
  }
  const double slope = q > 0 ? limit : -limit;
  r[component] = slope * (p_n + r.x()) - p;
  d(component, 0) = slope * d(0, 0);
}

}  // namespace

void refine_by_modes(const ContactProblem& problem, ContactState& state) {
  const std::size_t nc = problem.contacts.size();
  ContactMatrix matrix;
  matrix.attach(problem);
  std::vector<Mat3> stiffness(nc);
  std::vector<Vec3> change(nc), dv, best = state.impulse;
  double least = residual(problem, state).natural;
  for (int k = 0; k < kIterations; ++k) {
    for (std::size_t c = 0; c < nc; ++c) {
      const ContactRow& row = problem.contacts[c];
      const Vec3 w =
          delassus_diagonal(row, problem.inverse_mass[row.a], problem.inverse_mass[row.b]);
      const Vec3 u =
          row.offset + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
      const Vec3& p = state.impulse[c];
      Mat3& d = stiffness[c];
      Vec3& r = change[c];
      d.setZero();
      r = -p;  // open
      const double q_n = p.x() - u.x() / w.x();
      if (q_n <= 0) continue;
      r.setZero();
      r.x() = -u.x() / (kProximal * w.x());
      d(0, 0) = 1 / (kProximal * w.x());
      if (problem.components >= 2)
        tangential(p.y(), u.y(), w.y(), row.friction, q_n, p.x(), 1, r, d);
      if (problem.components >= 3)
        tangential(p.z(), u.z(), w.z(), row.rolling, q_n, p.x(), 2, r, d);
    }
    matrix.factorise(stiffness);
    matrix.velocity_change(change, dv);
    for (std::size_t c = 0; c < nc; ++c) {
      const ContactRow& row = problem.contacts[c];
      state.impulse[c] += change[c] - stiffness[c] * relative_velocity(row, dv[row.a], dv[row.b]);
    }
    const double reached = residual(problem, state).natural;
    if (reached < least) {
      least = reached;
      best = state.impulse;
    }
    if (!std::isfinite(reached)) break;
  }
  state.impulse = best;
  residual(problem, state);
}

}  // namespace quicksand::bench
