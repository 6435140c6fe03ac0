// The contact problems that solvers are compared on.
#pragma once

#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "app/bench/step_problem.h"

namespace quicksand::bench {

struct PrecisionProblem {
  std::string name;
  std::string what;
  StepProblem (*make)(const Options& options);
};
// In the order of the report.
const std::vector<PrecisionProblem>& precision_problems();

// With further values, as in run --set. A chain of so many disks below a fixed one, at dt = 1e-2 and F_c = 1e4 F_g (assets/scenes/chain.json).
Scenario chain_scene(int disks, const std::vector<std::string>& more = {});
// The clamped beam of assets/scenes/cantilever.json, at dt = 1e-2.
Scenario cantilever_scene(const std::vector<std::string>& more = {});

}  // namespace quicksand::bench
