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
  // Horizontal force of the pistons on the bodies, positive towards +x [F_g].
  std::optional<double> piston_shear;
};

// Zeros before the first step.
WallLoads wall_loads(const World& world);
// Force of the contacts of the last step on one wall, by its index in the world; 0 before the first step [F_g].
Vec2 force_on_wall(const World& world, int wall);

}  // namespace quicksand
