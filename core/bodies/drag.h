// Viscous drag of the fluid between the grains: a force against the velocity of each body,
//   F = -(gamma D + beta D^2 |v|) v
// with its diameter D. It is implicit in the step: with v at its start and v' at its end
//   m (v' - v) = dt f - dt (gamma D + beta D^2 |v|) v' + P
// for outer forces f and contact impulses P, so that a body moves as if it had the mass
// m + dt (gamma D + beta D^2 |v|), and no step is too long for it. Rotation is not damped.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/bodies/disks.h"

namespace quicksand {

struct Drag {
  double linear = 0;     // gamma of a grain of 1 d [F_g/sqrt(g d)]
  double quadratic = 0;  // beta of a grain of 1 d [F_g/(g d)]
  bool operator==(const Drag&) const = default;
};

// Multiplies what stands for the translation of each disk, its velocity without
// drag and contacts or its inverse mass, by m/(m + dt (gamma D + beta D^2 |v|)). `of_body` (nd or more)
// holds disks first.
void apply_drag(const Drag& drag, const Disks& disks, double dt, std::vector<Vec3>& of_body);

}  // namespace quicksand
