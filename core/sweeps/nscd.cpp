#include "core/sweeps/nscd.h"

#include <algorithm>
#include <cmath>

#include "core/problem/residual.h"
#include "core/problem/solver_settings.h"

namespace quicksand {

namespace {

// A residual costs about a sweep.
constexpr int kSweepsBetweenLooks = 10;

}  // namespace

SweptStep swept_step(const ContactProblem& problem, const ContactState& state,
                     const Residual& residual) {
  SweptStep step{.residual = residual.natural};
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    const double gap =
        problem.dt *
        (row.offset.x() + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]).x());
    step.penetration = std::max(step.penetration, -gap);
    if (row.cohesive && state.impulse[c].x() > 0)
      step.bond_gap = std::max(step.bond_gap, std::abs(gap));
  }
  return step;
}

SolveReport NscdSweeps::solve(const ContactProblem& problem, const Nscd& nscd,
                              const SolverSettings& accepted, ContactState& state, Random& random) {
  SolveReport report;
  packed_.load(problem, state.impulse);
  const int at_once = nscd.tolerance ? kSweepsBetweenLooks : nscd.sweeps;
  while (report.iterations < nscd.sweeps) {
    const int sweeps = std::min(at_once, nscd.sweeps - static_cast<int>(report.iterations));
    packed_.sweep(sweeps, nscd.order, random);
    report.iterations += sweeps;
    packed_.store(state.impulse);
    report.residual = residual(problem, state);
    if (nscd.tolerance && report.residual.natural <= *nscd.tolerance) break;
  }
  report.stage = SolverStage::sweeps;
  report.converged = accepted.accepts(report.residual);
  return report;
}

}  // namespace quicksand
