// Ballistic deposition: where a disk falling straight down first touches something. [Meakin 1987]
#pragma once

#include <optional>

#include "core/world.h"

namespace quicksand {

struct Landing {
  Vec2 centre{0, 0};  // of the falling disk when it touches [d]
  int touched = -1;   // the body that it touches
};

// A disk of this radius falling from above along the vertical through x lands on the highest disk in
// its way, or on a floor (a wall whose normal points up); nothing if there is neither.
std::optional<Landing> land(const World& world, double x, double radius);

}  // namespace quicksand
