// Gauss-Seidel where it is needed: only contacts that are off by more than the tolerance are solved, and
// looked at again when a neighbour was [Southwell 1940].
//
// Where sweeps over all contacts approach the tolerance, a few of several thousand keep them going, for
// thousands of sweeps: next to folds of the solution, impulses of small groups creep. And what all others
// are off by less than the tolerance need not be handed around.
#pragma once

#include <cstdint>
#include <vector>

#include "core/problem/by_body.h"
#include "core/problem/contact_problem.h"
#include "core/problem/solver_settings.h"

namespace quicksand {

// The memory of a relaxation, for whoever makes many.
struct RelaxationScratch {
  std::vector<Vec3> inverse_delassus;          // (nc)
  ByBody of_body;                              // contacts of those that are mobile
  std::vector<std::uint64_t> to_be_looked_at;  // a bit a contact
};

// Until the residual is below the tolerance, or as many contacts have been looked at as in
// settings.max_iterations sweeps; counts `iterations` in sweeps.
SolveReport solve_relaxation(const ContactProblem& problem, const SolverSettings& settings,
                             ContactState& state, RelaxationScratch& scratch);

}  // namespace quicksand
