// What a scene must not ask for.
#pragma once

#include <string>

#include "core/scene/scenario.h"
#include "core/world/world.h"

namespace quicksand {

// Throws InputError for what cannot be simulated: numbers that no step can be taken with (check_values.h), overlapping
// bodies (worse than 1e-6 d), bodies beyond a wall, phases that need a floor or gravity that is not there. Whoever builds
// a Scenario calls it before make_world, which takes everything as it is given.
void validate(const Scenario& scenario);

// Whether the phase puts an intruder into the world, and one that is no disk.
bool brings_intruder(const Phase& phase);
bool brings_shaped_intruder(const Phase& phase);

// Whether a piston stands after the phase, if one stood before it or not.
bool piston_stands_after(const Phase& phase, bool before);

// Whether the phase places bodies above all others, which come straight down.
bool places_from_above(const Phase& phase);
// The first of the world's first `walls` walls that may be in their way, as messages call it; empty if none is. The floor
// and sides of the box are not, nor are other floors.
std::string wall_in_the_way(const World& world, std::size_t walls);

}  // namespace quicksand
