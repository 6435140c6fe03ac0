// What a step does with energy. Contacts only dissipate, so without solver errors and artefacts
//   change <= work,
// where `change` is that of the kinetic energy, rotation included, and of F_c g of the bonds that last
// (each is pulled shut by F_c over its gap g), and `work` is done from outside: by gravity, by the forces
// on bodies and walls, and by what moves as prescribed. Drag takes from `change`. Pushing overlaps apart
// gives to it, and so does a solver that is not exact.
#pragma once

#include <vector>

#include "core/problem/contact_problem.h"
#include "core/world/world.h"

namespace quicksand {

struct EnergyBalance {
  double work = 0;    // [F_g d]
  double change = 0;  // [F_g d]
};

// Of a step of length dt from `world`, whose bonds are those after the step, to these velocities (nd + nw),
// by these contacts (nc) and the problem that they were solved in.
EnergyBalance energy_balance(const World& world, const std::vector<Contact>& contacts,
                             const ContactProblem& problem, const std::vector<Vec3>& velocity,
                             double dt);

}  // namespace quicksand
