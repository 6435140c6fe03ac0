// Which starts a solver takes as they are, and which motion is none.
#pragma once

#include <vector>

#include "core/problem/contact_problem.h"
#include "core/problem/solver_settings.h"

namespace quicksand {

// Whether no body has more momentum than the impulse by which a start that is taken as it is may be off at a contact,
// or than rounding.
bool at_rest(const ContactProblem& problem, const SolverSettings& settings,
             const std::vector<Vec3>& velocity);

// Whether a start with this residual and these velocities is taken as it is. The errors of all contacts of a long chain
// add up in the velocity of its end; so what begins at rest must stay at rest, or it is solved.
inline bool taken_as_it_is(const ContactProblem& problem, const SolverSettings& settings,
                           const Residual& residual, const std::vector<Vec3>& velocity) {
  return settings.distance(residual) <= SolverSettings::kAsItIs &&
         (!problem.from_rest || at_rest(problem, settings, velocity));
}

}  // namespace quicksand
