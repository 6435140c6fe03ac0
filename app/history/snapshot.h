// A world as a history keeps it: all that a picture, an inspection or an export reads of it, in few bytes.
//
// Coordinates are 64-bit integers in steps of 2^-25 d (3e-8 d), coarser ones only beyond 1e11 d, so that what touches
// still touches; angles, velocities and forces are 32-bit floats. Contacts without impulse and cohesion and random
// numbers are left out: nothing can be computed on from it.
#pragma once

#include <span>

#include "app/history/columns.h"
#include "core/world/world.h"

namespace quicksand {

Bytes snapshot_of(const World& world);

// Throws std::runtime_error with a phrase where the bytes are no snapshot of a possible world.
World world_from_snapshot(std::span<const std::uint8_t> bytes);

}  // namespace quicksand
