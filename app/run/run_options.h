// What a run was asked for besides its scene. It is kept as run.json beside the results, so that `resume`
// goes on in the same way.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/run_folder/validation.h"
#include "core/protocol/protocol.h"
#include "render/base/view.h"

namespace quicksand {

struct RunOptions {
  std::filesystem::path out;                            // empty: out/<scene name>
  std::optional<double> every;                          // time between samples [sqrt(d/g)]
  std::optional<std::filesystem::path> continued_from;  // state.cbor
  bool frames = true;
  double history_limit =
      256;  // size of history.qsh from which on it is thinned out [MB]; 0: none is written
  bool quiet = false;
  bool keep_earlier = false;     // of another run in the folder; true: refuses it
  bool lock = true;              // the folder; false: the caller has it locked
  double checkpoint_every = 60;  // wall time between checkpoints; 0: one a step [s]
  std::optional<StrictBounds> strict;
  // Called before each step, by the thread of the run.
  std::function<void(const Protocol&)> watch = {};
  View view;  // kept are colouring, theme, size, bonds and forces
};

// The longest times between samples [sqrt(d/g)] and between checkpoints [s] that may be asked for.
constexpr double kLongestSampleTime = 1e12;
constexpr double kLongestCheckpointTime = 1e6;
constexpr double kLargestHistory = 1e6;  // [MB]

// Writes and reads what is kept; `out`, `continued_from`, `quiet`, `keep_earlier`, `lock` and `watch` belong to the call.
// Throw InputError.
void write_options(const std::filesystem::path& file, const RunOptions& options);
RunOptions read_options(const std::filesystem::path& file);

}  // namespace quicksand
