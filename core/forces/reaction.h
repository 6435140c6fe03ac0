// What the contacts of the last step do to a body: the sum of their impulses over dt.
#pragma once

#include "core/world/world.h"

namespace quicksand {

// The parts of the upward force are signed; normal and tangential, or front, flank and shaft, add up to it.
struct Reaction {
  Vec2 force{0, 0};  // [F_g]
  double torque =
      0;  // about the centre of mass, counter-clockwise, rolling friction included [F_g d]
  double normal = 0;      // upward, of the normal forces [F_g]
  double tangential = 0;  // upward, of friction [F_g]
  double front = 0;       // upward, where the surface faces down within 45 degrees [F_g]
  double flank = 0;       // upward, elsewhere but at the shaft [F_g]
  double shaft = 0;       // upward, at parts that are shafts [F_g]
};

// Zeros before the first step.
Reaction reaction_on(const World& world, int body);

}  // namespace quicksand
