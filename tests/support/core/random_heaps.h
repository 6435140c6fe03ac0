// Small heaps of disks between walls, and the contact problem of their next step.
#pragma once

#include "core/base/random.h"
#include "core/problem/contact_problem.h"
#include "core/step/step_settings.h"
#include "core/world/world.h"

namespace quicksand {

struct HeapShape {
  int disks = 3;
  int components = 3;
  double largest_friction = 1;
  double mass_ratio = 1;  // masses between 1 and this
  bool piston = true;     // a wall with mass lies on the highest disk
  double bonded = 0;      // share of the contacts with a bond
};

// Unequal disks dropped onto each other between a floor and two side walls, with random velocities.
World random_heap(const HeapShape& shape, Random& random);

// What a solver gets from this world in a step from rest impulses.
ContactProblem next_problem(const World& world, const StepSettings& step = {});

}  // namespace quicksand
