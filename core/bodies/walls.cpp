#include "core/bodies/walls.h"

#include <cmath>

namespace quicksand {

Vec3 Wall::inverse_mass() const {
  if (mass == 0) return {0, 0, 0};
  return {std::abs(normal.x()) > 0.5 ? 1 / mass : 0, std::abs(normal.y()) > 0.5 ? 1 / mass : 0, 0};
}

}  // namespace quicksand
