#include "core/sweeps/gauss_seidel.h"

#include <algorithm>

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
  report.measure(problem, settings, state);
  if (!report.converged) report.stage = SolverStage::sweeps;
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
    report.measure(problem, settings, state);
  }
  return report;
}

}  // namespace quicksand
