// How high the grains lie, and what they weigh.
#pragma once

#include "core/world/world.h"

namespace quicksand {

// Top of the grains (intruders left out) [d]; 0 if there are none.
double packing_top(const World& world);

// Weight of all grains whose centres are above this height [F_g]; 0 without gravity.
double weight_above(const World& world, double height);

}  // namespace quicksand
