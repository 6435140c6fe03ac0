// The contacts of one step: pairs close enough to touch, with their geometry and impulses.
#pragma once

#include "core/base/types.h"
#include "core/bodies/bonds.h"

namespace quicksand {

// Geometry at the start of the step, impulses from its solution. Normal n from a to b, tangent
// t = perpendicular(n); impulses act on b, and on a the other way round.
struct Contact {
  Pair pair;
  Vec2 normal{0, 0};
  double gap = 0;         // at the start of the step, positive when apart [d]
  Vec3 impulse{0, 0, 0};  // (N, R_t, T): N = R_n + F_c dt of bonded contacts [m sqrt(g d)],
                          // T rolling [m d sqrt(g d)]
  double cohesion = 0;    // F_c if the bond is active, otherwise 0 [F_g]
  double turning =
      0;  // kappa by which the step of a bond was solved, see turning_rate(); not kept [g]

  bool operator==(const Contact&) const = default;

  // Both given the step that the impulses were computed with: R_n, positive where it pushes apart, and the resultant
  // force on b [F_g].
  double normal_force(double dt) const { return impulse.x() / dt - cohesion; }
  Vec2 force(double dt) const {
    return normal_force(dt) * normal + impulse.y() / dt * perpendicular(normal);
  }
};

}  // namespace quicksand
