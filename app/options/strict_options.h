// The options that say what a run must keep to be believed, the same for every command that computes one.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "app/run_folder/validation.h"

namespace quicksand {

struct StrictOptions {
  bool strict = false;
  double max_overlap = StrictBounds{}.max_overlap;  // [d]
};

void add_strict_options(CLI::App& command, StrictOptions& options);

// Nothing without --strict. Throws InputError if the bound is none.
std::optional<StrictBounds> strict_from(const StrictOptions& options);

}  // namespace quicksand
