// What the user is told when a run has ended, and what the shell is.
#pragma once

#include <string>

#include "app/run/run_scene.h"

namespace quicksand {

// Prints what became of a run and how to go on with it; returns the exit code.
int tell_outcome(const RunResult& result, const RunOptions& options);

// Of a run that ended well, but that failed the validation of --strict for these reasons: prints them if there are some;
// returns the exit code.
int tell_validation(const std::string& reasons);

}  // namespace quicksand
