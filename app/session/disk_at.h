// What a person points at, and what it is called.
#pragma once

#include <string>

#include "core/world/world.h"

namespace quicksand {

// The disk or shaped body at a place of the world, seen through periodic sides; -1 if there is none.
int disk_at(const World& world, const Vec2& place);

// The number of a disk; "floor", "side" or "piston" of a wall.
std::string body_name(const World& world, int body);

}  // namespace quicksand
