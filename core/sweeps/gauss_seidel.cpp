#include "core/sweeps/gauss_seidel.h"

#include <algorithm>

#include "core/problem/residual.h"
#include "core/sweeps/relax_contact.h"

namespace quicksand {

namespace {

// The residual costs about a sweep.
constexpr int kSweepsBetweenChecks = 20;

}  // namespace

SolveReport solve_gauss_seidel(const ContactProblem& problem, const SolverSettings& settings,
                               ContactState& state, WorkClock* clock) {
  std::vector<Vec3> inverse;
  inverse_delassus(problem, inverse);
  SolveReport report;
  const auto converged_now = [&] {
    report.residual = residual(problem, state);
    report.converged = settings.accepts(report.residual);
    return report.converged;
  };
  converged_now();
  if (!report.converged) report.stage = SolverStage::polish;
  while (!report.converged && report.iterations < settings.max_iterations) {
    WorkClock::look_up(clock);
    const auto sweeps =
        std::min<std::int64_t>(kSweepsBetweenChecks, settings.max_iterations - report.iterations);
    with_components(problem, [&]<int Components> {
      for (std::int64_t k = 0; k < sweeps; ++k)
        for (std::size_t c = 0; c < inverse.size(); ++c)
          relax_contact<Components>(problem, c, inverse[c], state);
    });
    report.iterations += sweeps;
    converged_now();
  }
  return report;
}

}  // namespace quicksand
