// What a scene must not ask for.
#pragma once

#include "core/scene/scenario.h"

namespace quicksand {

// Throws InputError for what cannot be simulated: overlapping bodies (worse than 1e-9 d), bodies
// beyond a wall, phases that need a floor or gravity that is not there.
void validate(const Scenario& scenario);

}  // namespace quicksand
