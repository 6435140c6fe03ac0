// Small worlds to look at, put together by hand.
#pragma once

#include "core/world/world.h"

namespace quicksand::worlds {

// Box of 8 x 6 d with periodic sides and a floor; two bonded columns and a bridge between them, one
// grain on the periodic side, some broken bonds, different speeds, forces.
World arch();
// The arch and an intruder above it that is pushed down.
World arch_with_intruder();
// Box of 8 x 6 d between walls under a piston, with three grains.
World between_walls();

}  // namespace quicksand::worlds
