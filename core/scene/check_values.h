// Numbers of a scene that no simulation can begin with, for scenes that programs build: those read from files have
// narrower ranges, which their schema names.
#pragma once

#include "core/scene/scenario.h"

namespace quicksand {

// Looks at steps, tolerances, gravity, drag, the box's width, contact laws, bodies with the forces on them, walls, and of
// phases at what all have. Throws InputError where one is not finite, a length or duration is not positive, or a
// coefficient is negative; its path is that of the same value in a file.
void check_values(const Scenario& scenario);

}  // namespace quicksand
