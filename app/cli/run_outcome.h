// What the user is told when a run has ended, and what the shell is.
#pragma once

#include <string>

#include "app/run/run_scene.h"

namespace quicksand {

// Prints what became of a run and how to go on with it; returns the exit code.
int tell_outcome(const RunResult& result, const RunOptions& options);

// With what a run may go on in which a step failed that could be halved so often: a phrase that may be empty, and an
// option of `run`.
struct OtherSteps {
  std::string what, setting;
};
OtherSteps other_steps(int most_halvings);

// Of a run that ended well, but that failed the validation of --strict for these reasons: prints them if there are some;
// returns the exit code.
int tell_validation(const std::string& reasons);

}  // namespace quicksand
