// The hanging chain and the clamped beam: weak structures whose solution is known. Both hold, so every
// velocity is zero, which is the reference.
#include "app/bench/cases/window.h"
#include "app/bench/goals/goal_cases.h"
#include "app/bench/precision/precision_problems.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/step/step.h"

namespace quicksand::bench {

namespace {

std::vector<std::string> tightly(const Options& options) {
  return {"solver.tolerance=1e-9", "solver.method=" + options.method};
}

Outcome first_step(const Scenario& scene, double goal, const Options& options) {
  const World world = make_world(scene);
  const StepProblem step = next_problem(world, scene.step);
  const Reference solution{
      .velocity = std::vector<Vec3>(step.problem.inverse_mass.size(), Vec3::Zero()),
      .residual = {},
      .doubt = 0};
  Outcome outcome;
  Figure time{.what = "first step", .unit = "ms", .goal = goal};
  for (int repeat = 0; repeat < options.repeats_or(9); ++repeat) {
    World moved = world;
    StepReport report;
    Row run = measure_step(moved, scene, options, report);
    run.repeat = repeat;
    run.size = mobile_disks(step.problem);
    run.contacts = static_cast<std::int64_t>(step.problem.contacts.size());
    if (report.taken)
      run.error = velocity_distance(step.problem, moved.disks.velocity, solution.velocity);
    time.valid = time.valid && report.converged;
    outcome.add(run, 1e3 * run.seconds.cpu, time);
  }
  outcome.figures = {time};
  compare_with_gauss_seidel(step, scene.solver, solution, options, outcome);
  const Reference tight = solve_tightly(step);
  outcome.notes.push_back(
      format("the reference is the closed form, rest; solved tightly (residual %.1e) it is %.1e g "
             "dt away, by two routes %.1e apart",
             tight.residual.natural,
             velocity_distance(step.problem, tight.velocity, solution.velocity), tight.doubt));
  return outcome;
}

}  // namespace

Outcome hanging_chain(const Options& options) {
  return first_step(chain_scene(options.quick ? 100 : 1000, tightly(options)), 10, options);
}

Outcome cantilever(const Options& options) {
  return first_step(cantilever_scene(tightly(options)), 1, options);
}

}  // namespace quicksand::bench
