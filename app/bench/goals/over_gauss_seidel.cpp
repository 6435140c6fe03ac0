#include "app/bench/goals/goal_cases.h"
#include "core/problem/solver_settings.h"

namespace quicksand::bench {

void compare_with_gauss_seidel(const StepProblem& step, const SolverSettings& settings,
                               const Reference& reference, const Options& options,
                               Outcome& outcome) {
  constexpr double kTightEnough = 1e-9;
  const Row solved = measure_solution(step, step.start, settings, reference, options);
  const double error = *solved.error;
  const Row swept = measure_gauss_seidel(step, step.start, error, reference, options);
  outcome.runs.push_back(solved);
  outcome.runs.push_back(swept);
  outcome.notes.push_back(format("Gauss-Seidel takes %s%.4g times as long to the same error",
                                 swept.unconverged > 0 ? "more than " : "",
                                 swept.seconds.cpu / solved.seconds.cpu));
  outcome.notes.push_back(
      format("one problem: %.3g ms to a velocity error of %.1e g dt, Gauss-Seidel %.1e after %.3g "
             "s; reference at residual %.1e, two routes %.1e g dt apart",
             1e3 * solved.seconds.cpu, error, *swept.error, swept.seconds.cpu,
             reference.residual.natural, reference.doubt));
  if (reference.residual.natural > kTightEnough || reference.doubt > error / 10)
    outcome.notes.emplace_back("the reference is not tight: take the velocity errors as rough");
}

}  // namespace quicksand::bench
