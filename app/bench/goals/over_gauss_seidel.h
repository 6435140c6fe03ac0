// How many times longer Gauss-Seidel takes than the solver of a goal, to the same velocity error.
#pragma once

#include "app/bench/goals/goal_case.h"
#include "app/bench/precision/velocity_error.h"
#include "core/problem/solver_settings.h"

namespace quicksand::bench {

// Both at one problem: a method at the given settings, then Gauss-Seidel to the same error, from the
// warm start. Adds two rows and a note to the outcome and sets its advantage.
void compare_with_gauss_seidel(const StepProblem& step, const SolverSettings& settings,
                               const Reference& reference, const Options& options,
                               Outcome& outcome);

}  // namespace quicksand::bench
