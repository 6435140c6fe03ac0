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
//
// With a capture radius [d] the first body whose surface comes this close to the disk's own draws it in
// along the line of centres. No third body is nearer than that, so none is in the way but a wall that
// is no floor; where one is, the disk goes on to its first touch.
std::optional<Landing> land(const World& world, double x, double radius, double capture = 0);

}  // namespace quicksand
