// How high the disks lie, and what they weigh.
#pragma once

#include <optional>

#include "core/world/world.h"

namespace quicksand {

// Top of the grains (intruders left out) [d]; 0 if there are none.
double packing_top(const World& world);
// The same with intruders [d].
double highest_point(const World& world);
// Where the packing begins: at the highest level floor or, without one, at the lowest point of the grains [d]; 0 if there
// are none.
double packing_bottom(const World& world);

// Distance of the sides [d]: of the innermost walls that face +x and -x or, without such walls, of periodic sides. Empty
// where a side is open or a wall is tilted.
std::optional<double> room_width(const World& world);

// Weight of all grains whose centres are above this height [F_g]; 0 without gravity.
double weight_above(const World& world, double height);

}  // namespace quicksand
