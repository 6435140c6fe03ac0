// The hanging chain and the clamped beam: weak structures whose solution is known. Both hold, so every
// velocity is zero, which is the reference.
#include <algorithm>
#include <array>
#include <cstdio>

#include "app/base/assets.h"
#include "app/bench/cases/window.h"
#include "app/bench/goals/goal_cases.h"
#include "app/bench/goals/over_gauss_seidel.h"
#include "app/scene/scene_file.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/step/step.h"

namespace quicksand::bench {

namespace {

constexpr const char* kTolerance = "solver.tolerance=1e-9";

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
    time.values.push_back(1e3 * run.seconds.cpu);
    outcome.runs.push_back(run);
    time.run = static_cast<int>(outcome.runs.size()) - 1;
  }
  outcome.figures = {time};
  compare_with_gauss_seidel(step, scene.solver, solution, options, outcome);
  const Reference tight = solve_tightly(step);
  std::array<char, 160> text{};
  std::snprintf(
      text.data(), text.size(),
      "the reference is the closed form, rest; solved tightly (residual %.1e) it is %.1e g dt "
      "away, by two routes %.1e apart",
      tight.residual.natural, velocity_distance(step.problem, tight.velocity, solution.velocity),
      tight.doubt);
  outcome.notes.emplace_back(text.data());
  return outcome;
}

}  // namespace

Outcome hanging_chain(const Options& options) {
  const int disks = options.quick ? 100 : 1000;
  const std::string top = std::to_string(disks + 3), next = std::to_string(disks + 2);
  const Scenario scene = read_scene(
      {.file = shipped_scene("chain"),
       .overrides = {"box.height=" + std::to_string(disks + 4),
                     "bodies[0].position=[5," + top + "]", "bodies[1].position=[5," + next + "]",
                     "bodies[1].repeat.count=" + std::to_string(disks),
                     "contact.cohesion_force=1e4", "step.dt=1e-2", kTolerance,
                     "solver.method=" + options.method},
       .seed = {}});
  return first_step(scene, 10, options);
}

Outcome cantilever(const Options& options) {
  const Scenario scene =
      read_scene({.file = shipped_scene("cantilever"),
                  .overrides = {"step.dt=1e-2", kTolerance, "solver.method=" + options.method},
                  .seed = {}});
  return first_step(scene, 1, options);
}

}  // namespace quicksand::bench
