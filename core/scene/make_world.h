// From a scene to the world at its start.
#pragma once

#include "core/scene/scenario.h"
#include "core/world/world.h"

namespace quicksand {

// The world at the start of a scene: its box, walls and listed disks. Does not read start_from.
World make_world(const Scenario& scenario);

// Gravity, drag and contact laws of the scene, in a world that may be under way.
void take_laws(World& world, const Scenario& scenario);

}  // namespace quicksand
