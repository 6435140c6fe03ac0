// The options for the validation of a run, the same for every command that computes one.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "app/run_folder/validation.h"

namespace quicksand {

struct StrictOptions {
  bool strict = false;
  StrictBounds bounds;
};

void add_strict_options(CLI::App& command, StrictOptions& options);

// Nothing without --strict.
std::optional<StrictBounds> strict_from(const StrictOptions& options);

}  // namespace quicksand
