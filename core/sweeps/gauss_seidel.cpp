#include "core/sweeps/gauss_seidel.h"

#include <algorithm>

#include "core/problem/residual.h"
#include "core/sweeps/relax_contact.h"

namespace quicksand {

namespace {

// Judging a state costs about a sweep.
constexpr int kSweepsBetweenJudgements = 20;

}  // namespace

SolveReport solve_gauss_seidel(const ContactProblem& problem, const SolverSettings& settings,
                               ContactState& state) {
  const std::vector<Vec3> inverse = inverse_delassus(problem);
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
    with_components(problem, [&]<int Components> {
      for (std::int64_t k = 0; k < sweeps; ++k)
        for (std::size_t c = 0; c < inverse.size(); ++c)
          relax_contact<Components>(problem, c, inverse[c], state);
    });
    report.iterations += sweeps;
    judge();
  }
  return report;
}

}  // namespace quicksand
