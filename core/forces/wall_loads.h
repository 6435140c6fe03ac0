// What the contacts of the last step do to the walls.
#pragma once

#include <optional>

#include "core/world/world.h"

namespace quicksand {

// Each empty where there is no such wall. At rest, floor and sides together bear the weight of all bodies, and what the
// piston presses with; the share of the sides is that of Janssen's silo.
struct WallLoads {
  std::optional<double> floor;  // downward force on the floors [F_g]
  std::optional<double> side;  // downward force on the sides, by friction if they are upright [F_g]
  std::optional<double>
      side_thrust;  // normal force on the sides, positive if bodies press on them [F_g]
  std::optional<double>
      piston;  // normal force on the pistons, positive if bodies press on them [F_g]
};

// Zeros before the first step.
WallLoads wall_loads(const World& world);

}  // namespace quicksand
