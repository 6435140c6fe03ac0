#include "app/bench/goals/over_gauss_seidel.h"

#include <array>
#include <cstdio>

#include "core/problem/solver_settings.h"

namespace quicksand::bench {

namespace {

constexpr double kTightEnough = 1e-9;

}  // namespace

void compare_with_gauss_seidel(const StepProblem& step, const SolverSettings& settings,
                               const Reference& reference, const Options& options,
                               Outcome& outcome) {
  const Row solved = measure_solution(step, step.start, settings, reference, options);
  const double error = *solved.error;
  const Row swept = measure_gauss_seidel(step, step.start, error, reference, options);
  outcome.runs.push_back(solved);
  outcome.runs.push_back(swept);
  outcome.over_gauss_seidel = {.factor = swept.seconds.cpu / solved.seconds.cpu,
                               .at_least = swept.unconverged > 0};
  std::array<char, 240> text{};
  std::snprintf(
      text.data(), text.size(),
      "one problem: %.3g ms to a velocity error of %.1e g dt, Gauss-Seidel %.1e after %.3g "
      "s; reference at residual %.1e, two routes %.1e g dt apart",
      1e3 * solved.seconds.cpu, error, *swept.error, swept.seconds.cpu, reference.residual.natural,
      reference.doubt);
  outcome.notes.emplace_back(text.data());
  if (reference.residual.natural > kTightEnough || reference.doubt > error / 10)
    outcome.notes.emplace_back("the reference is not tight: take the velocity errors as rough");
}

}  // namespace quicksand::bench
