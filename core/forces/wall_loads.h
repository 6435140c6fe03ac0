// What the contacts of the last step do to the walls.
#pragma once

#include <optional>

#include "core/world/world.h"

namespace quicksand {

// Each empty where there is no such wall: floors face up, and lids, which face down, count as pistons, unless a wall's role
// says otherwise. At rest, floors and sides together bear the downward part of the weight of bodies, of what the pistons
// press with and of forces on bodies, less what fixed bodies carry; the share of the sides is that of Janssen's silo.
struct WallLoads {
  std::optional<double> floor;  // downward force on the floors [F_g]
  std::optional<double> side;  // downward force on the sides, by friction if they are upright [F_g]
  std::optional<double>
      side_thrust;  // normal force, summed over the sides, positive if bodies press on them [F_g]
  std::optional<double> piston;  // the same of pistons [F_g]
};

// Zeros before the first step.
WallLoads wall_loads(const World& world);

}  // namespace quicksand
