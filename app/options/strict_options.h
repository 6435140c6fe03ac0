// The options for the validation of a run, the same for every command that computes one.
#pragma once

#include <optional>

#include "app/options/cli_app.h"
#include "app/run_folder/validation.h"

namespace quicksand {

// Without --strict nothing is set.
void add_strict_options(CLI::App& command, std::optional<StrictBounds>& bounds);

}  // namespace quicksand
