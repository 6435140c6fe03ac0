// Runs a scene from its first step, or from a state, to its end, and leaves the results in a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/run/run_folder.h"
#include "app/run/summary.h"
#include "core/scenario.h"
#include "render/view.h"

namespace quicksand {

struct RunOptions {
  std::filesystem::path out;                            // empty: out/<scene name>
  std::optional<double> every;                          // time between samples [sqrt(d/g)]
  std::optional<std::filesystem::path> continued_from;  // state.cbor
  bool frames = true;
  bool quiet = false;
  View view;
};

struct RunResult {
  RunFolder folder;
  RunEnd end;
  std::string notes;  // lines about what the user may miss, such as a film
};

// Throws InputError or RenderError before anything is computed. Later failures are in the result.
RunResult run_scene(const Scenario& scenario, const RunOptions& options);

}  // namespace quicksand
