// Which starts a solver takes as they are, and which motion is none.
#pragma once

#include "core/problem/contact_problem.h"
#include "core/problem/solver_settings.h"

namespace quicksand {

// Takes the velocity of each body at a loaded contact whose momentum is no more than the impulse by which a start that is
// taken as it is may be off there, and next to nothing beside what its loads give it, or no more than rounding: it is at
// rest. Where no contact is loaded nothing is off: a body in the air falls, however slowly. `by_loads` (nb): what loads
// alone change velocities by in the step. Returns whether all bodies are at rest.
bool bring_to_rest(const ContactProblem& problem, const SolverSettings& settings,
                   const std::vector<Vec3>& by_loads, ContactState& state);

// Whether a start with this residual is taken as it is: where it is exact, or nearly so and no body at a loaded contact
// moves. What is wrong at the contacts of a branch adds up in the velocity of its end, and would be handed on from step to
// step.
bool taken_as_it_is(const ContactProblem& problem, const SolverSettings& settings,
                    const Residual& residual, const ContactState& state);

}  // namespace quicksand
