// Numbers of a scene that no simulation can begin with, for scenes that programs build: those read from files have
// narrower ranges, which their schema names.
#pragma once

#include "core/scene/scenario.h"

namespace quicksand {

// Throws InputError where a number is not finite, a length or duration is not positive, a coefficient is negative, or the
// normal of a wall is not of unit length; its path is that of the same value in a file.
void check_values(const Scenario& scenario);

}  // namespace quicksand
