// The intact network, cold: no contact gives any force yet, and the whole weight has to be found. Time
// of one solution, ordering included, at the loosest tolerance whose velocity error is under 1e-3 g dt.
//
// Two networks of 5000 grains: one that stands (the packing at rest, its forces forgotten) and one that
// does not (a deposit in the paper's box without dynamics, whose branches fall at about g dt).
#include <array>

#include "app/bench/goals/goal_cases.h"
#include "app/bench/paper_states.h"
#include "app/bench/precision/velocity_error.h"
#include "core/problem/solver_settings.h"

namespace quicksand::bench {

namespace {

constexpr double kError = 1e-3;  // [g dt]

// Adds two figures, the runs behind them and a note.
void solve_cold(const std::string& network, const World& world, const Scenario& scene,
                const Options& options, Outcome& outcome) {
  constexpr std::array kTolerances{1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
  StepProblem step = next_problem(world, scene.step);
  step.start = step.no_force;
  const Reference reference = solve_tightly(step);

  Figure time{.what = network, .unit = "ms", .goal = 20};
  Figure ratio{.what = "over Gauss-Seidel", .unit = "times", .goal = 1000, .more_is_better = true};
  SolverSettings settings = scene.solver;
  time.valid = false;
  for (const double tolerance : kTolerances) {
    settings.tolerance = tolerance;
    Row run = measure_solution(step, step.start, settings, reference, options);
    run.what = network + "_tolerance";
    time.valid = *run.error < kError;
    outcome.runs.push_back(run);
    if (time.valid) break;
  }
  for (int repeat = 0; repeat < options.repeats_or(7); ++repeat) {
    Row run = measure_solution(step, step.start, settings, reference, options);
    run.what = network;
    run.repeat = repeat;
    outcome.add(run, 1e3 * run.seconds.cpu, time);
  }
  Row swept = measure_gauss_seidel(step, step.start, kError, reference, options);
  swept.what = network + "_gauss_seidel";
  outcome.runs.push_back(swept);
  ratio.valid = time.valid;
  ratio.at_least = swept.unconverged > 0;
  for (const double ms : time.values) ratio.values.push_back(1e3 * swept.seconds.cpu / ms);
  outcome.figures.push_back(time);
  outcome.figures.push_back(ratio);
  outcome.notes.push_back(
      format("%s: tolerance %.0e%s; Gauss-Seidel %.1e g dt off after %lld sweeps and %.3g s; "
             "reference at residual %.1e, two routes %.1e g dt apart",
             network.c_str(), settings.tolerance,
             time.valid ? "" : ", and no looser one reaches 1e-3 g dt either", *swept.error,
             static_cast<long long>(swept.iterations), swept.seconds.cpu,
             reference.residual.natural, reference.doubt));
}

}  // namespace

Outcome intact_network(const Options& options) {
  const Scenario scene = paper_scene(options, options.method);
  Outcome outcome;
  solve_cold("standing", at_rest(options).world, scene, options, outcome);
  solve_cold("falling", fresh_deposit(options, options.quick ? 400 : 5000), scene, options,
             outcome);
  return outcome;
}

}  // namespace quicksand::bench
