// Small scenes with closed forms. All have open sides, no floor and unit disks unless they say
// otherwise, and a tight solver.
#pragma once

#include "core/scene/scenario.h"

namespace quicksand {

inline constexpr double kRange = 5e-5;  // how far the bonds of paper_law reach: d_c [d]

// Nothing in it: no gravity, no walls, no friction.
Scenario empty_scene(Method method);
// Friction 0.3 and rolling friction 0.1, the paper's, and bonds if a cohesion is given.
ContactLaw paper_law(double cohesion = 0);

// n disks standing on each other on the floor, just touching, under gravity.
Scenario column(Method method, int n, const ContactLaw& law = {});
// n bonded disks in a row, at x = 0.5 to n - 0.5, without gravity: n - 1 bonds.
Scenario bonded_row(int n);
// n bonded disks hanging from a fixed one, disk 0.
Scenario hanging_chain(Method method, int n, double cohesion);
// n bonded disks sticking out of a fixed one, disk 0, to the right.
Scenario cantilever(Method method, int n, double cohesion);
// One disk at rest at the origin on a wall of this slope, descending to +x.
Scenario incline(Method method, double slope, const ContactLaw& law);
// Two bonded disks along x in free space, spinning rigidly about their middle.
Scenario spinning_pair(Method method, double spin, double cohesion);
// The first disk fixed, the second pulled away along x.
Scenario pulled_pair(Method method, double force, double cohesion);
// About n disks of unequal size over a floor, apart, with random velocities, falling.
Scenario falling_cluster(Method method, int n, std::uint64_t seed, const ContactLaw& law);
// Ballistic deposition and a settling, then a push: every phase, in a periodic box.
Scenario small_collapse(Method method, std::uint64_t seed = 1);

// The same scene seen from a frame turned by `angle`: bodies, walls, velocities, forces, gravity.
Scenario rotated(const Scenario& scenario, double angle);
// The same scene in a mirror at x = 0.
Scenario mirrored(const Scenario& scenario);

}  // namespace quicksand
