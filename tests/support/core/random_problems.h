// Contact problems without a world, as small as a reference can solve by trying everything.
#pragma once

#include "core/base/random.h"
#include "core/problem/contact_problem.h"

namespace quicksand {

struct ProblemShape {
  int bodies = 3;
  int contacts = 3;
  int components = 3;
  double largest_friction = 1;
  double mass_ratio = 1;   // masses between 1 and this
  bool fixed_body = true;  // body 0 does not move
  bool disks = true;  // else bodies of any shape, and known relative velocities in all directions
};

// Bodies of unequal size in random positions, with random free velocities; contact geometry need not
// fit into the plane, the laws do not ask for it.
ContactProblem random_problem(const ProblemShape& shape, Random& random);

// A grain, body 0, that touches a floor, body 1, with a free velocity. Tangent t = (1, 0); impulses act
// on the floor and, the other way round, on the grain.
ContactProblem disk_on_floor(const Vec3& free_velocity, double friction, double rolling);

ContactState zero_state(const ContactProblem& problem);

// Puts NaN into the coefficients that a problem with so many components must not read.
void poison_unused_coefficients(ContactProblem& problem);
// And into the arms, which only friction needs.
void poison_unused_arms(ContactProblem& problem);

}  // namespace quicksand
