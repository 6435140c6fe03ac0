// Runs a scene from its first step, or from a state, to its end, and leaves the results in a folder.
#pragma once

#include <string>
#include <vector>

#include "app/run/run_options.h"
#include "app/run_folder/run_folder.h"
#include "app/run_folder/summary.h"
#include "core/scene/scenario.h"

namespace quicksand {

struct RunResult {
  RunFolder folder;
  RunEnd end;
  int most_halvings = 0;           // that a step may take
  std::string invalid;             // by --strict, a sentence; empty: nothing is wrong
  std::vector<std::string> notes;  // lines about what the user may miss, such as a film
};

// Throws InputError or RenderError before anything is computed. Later failures are in the result.
RunResult run_scene(const Scenario& scenario, const RunOptions& options);

}  // namespace quicksand
