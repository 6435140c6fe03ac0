// The intact network, cold: a deposit without dynamics in which no contact gives any force yet. Time of
// one solution, ordering included, at the loosest tolerance whose velocity error is under 1e-3 g dt.
#include <array>
#include <cstdio>

#include "tests/bench/cases.h"
#include "tests/bench/paper_states.h"
#include "tests/bench/velocity_error.h"

namespace quicksand::bench {

Outcome intact_network(const Options& options) {
  constexpr double kError = 1e-3;  // [g dt]
  constexpr std::array kTolerances{1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
  const Scenario scene = paper_scene(options, options.method);
  StepProblem step = next_problem(fresh_deposit(options, options.quick ? 400 : 5000), scene.step);
  step.start = step.no_force;
  const Reference reference = solve_tightly(step);

  Outcome outcome;
  Figure time{.what = "one solution", .unit = "ms", .goal = 20};
  Figure ratio{.what = "over Gauss-Seidel", .unit = "times", .goal = 1000, .more_is_better = true};
  SolverSettings settings = scene.solver;
  time.valid = false;
  for (const double tolerance : kTolerances) {
    settings.tolerance = tolerance;
    Run run = measure_solution(step, step.start, settings, reference, options);
    run.part = "tolerance";
    time.valid = *run.velocity_error < kError;
    outcome.runs.push_back(run);
    if (time.valid) break;
  }
  for (int repeat = 0; repeat < options.repeats_or(7); ++repeat) {
    Run run = measure_solution(step, step.start, settings, reference, options);
    run.repeat = repeat;
    time.values.push_back(1e3 * run.seconds.cpu);
    outcome.runs.push_back(run);
  }
  const Run swept = measure_gauss_seidel(step, step.start, kError, reference, options);
  outcome.runs.push_back(swept);
  ratio.valid = time.valid;
  ratio.at_least = swept.unconverged > 0;
  for (const double ms : time.values) ratio.values.push_back(1e3 * swept.seconds.cpu / ms);
  outcome.figures = {time, ratio};
  std::array<char, 240> text{};
  std::snprintf(
      text.data(), text.size(),
      "tolerance %.0e; Gauss-Seidel %.1e g dt off after %lld sweeps and %.3g s; reference "
      "at residual %.1e, second route %.1e g dt away",
      settings.tolerance, *swept.velocity_error, static_cast<long long>(swept.iterations),
      swept.seconds.cpu, reference.residual.natural, reference.doubt);
  outcome.notes.emplace_back(text.data());
  if (!time.valid)
    outcome.notes.emplace_back("no tolerance down to 1e-11 gives that velocity error");
  return outcome;
}

}  // namespace quicksand::bench
