// How the cost of a step grows with the number of grains: the first step of fresh deposits in boxes of
// one shape, search for contacts included.
#include <algorithm>

#include "app/bench/cases/window.h"
#include "app/bench/goals/goal_cases.h"
#include "app/bench/paper_states.h"
#include "app/bench/statistics.h"
#include "core/scene/scenario.h"
#include "core/step/step.h"

namespace quicksand::bench {

Outcome growth(const Options& options) {
  const std::vector<std::int64_t> sizes =
      options.quick ? std::vector<std::int64_t>{200, 400, 800}
                    : std::vector<std::int64_t>{1000, 3162, 10000, 31623, 100000};
  const Scenario scene = paper_scene(options, options.method);
  const int repeats = options.repeats_or(3);
  Outcome outcome;
  Figure growing{.what = "exponent", .unit = "1", .goal = 1.15};
  std::vector<double> grains, per_factorisation;
  std::vector<std::vector<double>> seconds(static_cast<std::size_t>(repeats));
  for (const std::int64_t size : sizes) {
    const World fresh = fresh_deposit(options, size);
    grains.push_back(static_cast<double>(size));
    for (int repeat = 0; repeat < repeats; ++repeat) {
      World world = fresh;
      StepReport report;
      Row run = measure_step(world, scene, options, report);
      run.repeat = repeat;
      run.size = size;
      growing.valid = growing.valid && report.converged;
      seconds[static_cast<std::size_t>(repeat)].push_back(run.seconds.cpu);
      outcome.runs.push_back(run);
    }
    const Row& last = outcome.runs.back();
    per_factorisation.push_back(
        last.seconds.cpu / static_cast<double>(std::max<std::int64_t>(1, last.factorisations)));
    outcome.notes.push_back(std::to_string(size) +
                            " grains: " + std::to_string(1e3 * last.seconds.cpu) + " ms, " +
                            std::to_string(last.factorisations) + " factorisations" +
                            (last.unconverged > 0 ? ", NOT converged" : ""));
  }
  outcome.notes.push_back("exponent of the cost per factorisation: " +
                          std::to_string(exponent(grains, per_factorisation)));
  for (const std::vector<double>& of_repeat : seconds)
    growing.values.push_back(exponent(grains, of_repeat));
  growing.run = static_cast<int>(outcome.runs.size()) - 1;
  outcome.figures = {growing};
  return outcome;
}

}  // namespace quicksand::bench
