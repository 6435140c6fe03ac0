// What a person points at.
#pragma once

#include "core/world/world.h"

namespace quicksand {

// The disk at a place of the world, seen through periodic sides; -1 if there is none.
int disk_at(const World& world, const Vec2& place);

}  // namespace quicksand
