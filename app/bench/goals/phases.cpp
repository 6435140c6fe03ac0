// Deposition, rest, ploughing and a piston: steps per second over a phase, its preparation not counted.
#include <limits>

#include "app/bench/cases/window.h"
#include "app/bench/goals/goal_cases.h"
#include "app/bench/paper_states.h"
#include "core/measures/measures.h"
#include "core/scene/make_world.h"
#include "core/world/extent.h"

namespace quicksand::bench {

namespace {

Figure steps_per_second(double goal) {
  return {.what = "steps", .unit = "1/s", .goal = goal, .more_is_better = true};
}

// Takes a window as a repeat of the figure.
void add(const Window& window, const Scenario& scene, int repeat, Figure& figure,
         Outcome& outcome) {
  Row run = window.run;
  run.repeat = repeat;
  run.tolerance = scene.solver.tolerance;
  outcome.add(run, static_cast<double>(run.steps) / run.seconds.cpu, figure);
  if (!window.failure.empty()) {
    figure.valid = false;
    outcome.notes.push_back(window.failure);
  }
}

}  // namespace

Outcome deposition(const Options& options) {
  Scenario scene = paper_scene(options, options.method);
  scene.phases.resize(1);
  Outcome outcome;
  Figure figure = steps_per_second(500);
  World full;
  for (int repeat = 0; repeat < options.repeats_or(1); ++repeat) {
    Protocol protocol(scene, make_world(scene));
    add(measure_window(protocol, {.steps = std::numeric_limits<std::int64_t>::max()}, options),
        scene, repeat, figure, outcome);
    full = protocol.world();
    if (figure.valid && options.method == "auto")
      keep_deposited(options, {protocol.world(), protocol.state(), {}});
  }
  outcome.figures = {figure};
  const StepProblem step = next_problem(full, scene.step);
  compare_with_gauss_seidel(step, scene.solver, options, outcome);
  return outcome;
}

Outcome rest(const Options& options) {
  Scenario scene = paper_scene(options, options.method);
  const std::int64_t steps = options.quick ? 200 : 2000;
  scene.phases = {watching(static_cast<double>(steps) * scene.step.dt)};
  const World world = at_rest(options).world;
  Outcome outcome;
  Figure figure = steps_per_second(20000);
  for (int repeat = 0; repeat < options.repeats_or(3); ++repeat) {
    Protocol protocol(scene, world);
    add(measure_window(protocol, {.steps = steps}, options), scene, repeat, figure, outcome);
  }
  outcome.figures = {figure};
  const StepProblem step = next_problem(world, scene.step);
  compare_with_gauss_seidel(step, scene.solver, options, outcome);
  return outcome;
}

Outcome plough(const Options& options) {
  constexpr double kGapError = 0.1;  // [d_c]
  const std::int64_t steps = options.quick ? 20 : 200;
  Scenario scene = paper_scene(options, options.method);
  const Checkpoint start = ploughing(options);
  // The phase ends with the window at the latest, so that the time left can be told.
  const StepSettings step_settings = step_in_phase(scene, start.protocol.phase);
  std::get<PushPhase>(scene.phases.at(static_cast<std::size_t>(start.protocol.phase)).kind)
      .max_time =
      start.world.time - start.protocol.phase_start + static_cast<double>(steps) * step_settings.dt;
  Outcome outcome;
  Figure figure = steps_per_second(100);
  for (int repeat = 0; repeat < options.repeats_or(3); ++repeat) {
    Protocol protocol(scene, start.world, start.protocol);
    const Window window = measure_window(protocol, {.steps = steps}, options);
    add(window, scene, repeat, figure, outcome);
    figure.valid = figure.valid && window.run.gap_error <= kGapError;
  }
  outcome.figures = {figure};
  const StepProblem step = next_problem(start.world, step_settings);
  compare_with_gauss_seidel(step, scene.solver, options, outcome);
  return outcome;
}

// Collapse under a piston, the hardest case: a loose packing is crushed to a dense one, bonds break
// everywhere, and at its end the contacts are more than what their forces can be told from.
Outcome piston(const Options& options) {
  constexpr double kCoordination = 3.2;  // at the end
  const Scenario scene = piston_scene(options, options.method);
  const World start = under_piston(options);
  const WindowSettings settings{
      .steps = 4000, .patience = options.quick ? 4.0 : 600.0, .reached = [](const World& world) {
        return world.step % 10 == 0 && measure(world).coordination >= kCoordination;
      }};
  Outcome outcome;
  Figure figure = steps_per_second(25);
  World end;
  for (int repeat = 0; repeat < options.repeats_or(1); ++repeat) {
    Protocol protocol(scene, start);
    const Window window = measure_window(protocol, settings, options);
    end = protocol.world();
    const double z = measure(end).coordination;
    outcome.notes.push_back(format("coordination number %.3f after t = %.3f and %lld steps", z,
                                   end.time - start.time,
                                   static_cast<long long>(window.run.steps)));
    add(window, scene, repeat, figure, outcome);
    figure.valid = figure.valid && window.run.unconverged == 0 && z >= kCoordination;
  }
  outcome.figures = {figure};
  compare_with_gauss_seidel(next_problem(end, step_in_phase(scene, 0)), scene.solver, options,
                            outcome);
  return outcome;
}

}  // namespace quicksand::bench
