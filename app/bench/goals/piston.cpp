// Collapse under a piston, the hardest case: a loose packing is crushed to a dense one, bonds break
// everywhere, and at its end the contacts are more than what their forces can be told from.
#include "app/bench/cases/window.h"
#include "app/bench/goals/goal_cases.h"
#include "app/bench/paper_states.h"
#include "core/measures/measures.h"
#include "core/scene/scenario.h"
#include "core/world/extent.h"

namespace quicksand::bench {

namespace {

constexpr double kPressure = 3e5 / 51, kMassPerWidth = 500.0 / 51;  // of the piston [F_g/d], [m/d]
constexpr double kStep = 5e-3;                                      // [sqrt(d/g)]
constexpr double kLongest = 20;                                     // [sqrt(d/g)]
constexpr double kCoordination = 3.2;

// The settled packing with a piston on its top; contacts made from now on are plain.
World under_piston(const Options& options) {
  World world = settled(options).world;
  world.walls.push_back({.point = {0, packing_top(world)},
                         .normal = {0, -1},
                         .mass = kMassPerWidth * world.box.width,
                         .force = kPressure * world.box.width,
                         .role = WallRole::piston});
  world.bonding = false;
  world.bonds.mark_initial();
  return world;
}

}  // namespace

Outcome piston(const Options& options) {
  Scenario scene = paper_scene(options, options.method);
  scene.step.max_turn.reset();
  scene.phases = {{.kind = SettlePhase{.max_time = kLongest, .until_rest = false}, .dt = kStep}};
  const World start = under_piston(options);
  const WindowSettings settings{
      .steps = 4000, .patience = options.quick ? 4.0 : 600.0, .reached = [](const World& world) {
        return world.step % 10 == 0 && measure(world).coordination >= kCoordination;
      }};
  Outcome outcome;
  Figure figure{.what = "steps", .unit = "1/s", .goal = 25, .more_is_better = true};
  World end;
  for (int repeat = 0; repeat < options.repeats_or(1); ++repeat) {
    Protocol protocol(scene, start);
    const Window window = measure_window(protocol, settings, options);
    Row run = window.run;
    run.repeat = repeat;
    run.tolerance = scene.solver.tolerance;
    outcome.add(run, static_cast<double>(run.steps) / run.seconds.cpu, figure);
    end = protocol.world();
    const double z = measure(end).coordination;
    figure.valid =
        figure.valid && window.failure.empty() && run.unconverged == 0 && z >= kCoordination;
    outcome.notes.push_back(format("coordination number %.3f after t = %.3f and %lld steps", z,
                                   end.time - start.time, static_cast<long long>(run.steps)));
    if (!window.failure.empty()) outcome.notes.push_back(window.failure);
  }
  outcome.figures = {figure};
  const StepProblem step = next_problem(end, step_in_phase(scene, 0));
  compare_with_gauss_seidel(step, scene.solver, options, outcome);
  return outcome;
}

}  // namespace quicksand::bench
