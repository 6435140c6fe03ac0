// Straight, infinite, rigid walls: the floor, side walls, pistons.
#pragma once

#include <cmath>

#include "core/base/types.h"

namespace quicksand {

enum class WallRole : std::uint8_t { floor, side, piston };

struct Wall {
  Vec2 point{0, 0};     // any point of the surface [d]
  Vec2 normal{0, 1};    // unit, into the free side
  Vec2 velocity{0, 0};  // [sqrt(g d)]
  double mass = 0;      // [grain masses]; 0: the motion is prescribed by `velocity`
  double force = 0;     // along the normal, on a wall with mass [F_g]
  WallRole role = WallRole::floor;

  // Inverse mass for (x, y, rotation): a wall with mass moves along its normal only, which must
  // then be parallel to x or y; others do not respond to forces.
  Vec3 inverse_mass() const {
    if (mass == 0) return {0, 0, 0};
    return {std::abs(normal.x()) > 0.5 ? 1 / mass : 0, std::abs(normal.y()) > 0.5 ? 1 / mass : 0,
            0};
  }
  bool operator==(const Wall&) const = default;
};

// What bodies that fall come to lie on.
inline bool is_floor(const Wall& wall) { return wall.normal.y() > 0.5; }
// What presses from above.
inline bool is_pressing_piston(const Wall& wall) {
  return wall.role == WallRole::piston && wall.mass > 0 && wall.normal.y() < -0.5;
}
inline bool is_tilted(const Wall& wall) { return wall.normal.x() != 0 && wall.normal.y() != 0; }

}  // namespace quicksand
