// The numbers of a scene's phases that would never end or that nothing can be made of; see check_values.h.
#pragma once

#include "core/scene/scenario.h"

namespace quicksand {

// Throws InputError where a duration, length, mass or number of a phase is none, or the shape of an intruder has a
// problem (intruder_shapes.h).
void check_phase_values(const Scenario& scenario);

}  // namespace quicksand
