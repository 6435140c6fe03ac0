// Solvers against the reference that tries every combination of contact modes.
#pragma once

#include <functional>
#include <set>

#include "core/problem/solver_settings.h"
#include "tests/support/core/random_problems.h"
#include "tests/support/core/reference_solver.h"

namespace quicksand {

struct Agreement {
  int compared = 0;  // with a reference that leaves no choice
  int agreeing = 0;  // with a solution of the reference, whether or not it leaves a choice
  int unconverged = 0;
  std::set<Mode> modes;  // of all contacts
};

// Solves problems from a cold start. What converged must obey the laws and, where they leave no choice,
// have the velocities that trying every mode finds. `next` makes the problems.
// `accuracy` is in impulse and velocity.
Agreement compare(const SolverSettings& settings, int problems,
                  const std::function<ContactProblem()>& next, double accuracy);
// The same with random problems of a shape and a tight tolerance.
Agreement compare(Method method, const ProblemShape& shape, int problems, std::uint64_t seed);

// A tight tolerance, and enough sweeps to meet it.
SolverSettings tight(Method method);

}  // namespace quicksand
