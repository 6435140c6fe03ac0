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

// Whether a start with this residual and these velocities is taken as it is: where it is exact, or nearly so and all
// bodies rest. What is wrong at the contacts of a branch adds up in the velocity of its end, and would be handed on from
// step to step.
inline bool taken_as_it_is(const ContactProblem& problem, const SolverSettings& settings,
                           const Residual& residual, const std::vector<Vec3>& velocity) {
  const double distance = settings.distance(residual);
  return distance == 0 ||
         (distance <= SolverSettings::kAsItIs && at_rest(problem, settings, velocity));
}

}  // namespace quicksand
