// Where the intruder has been: the line that its centre has drawn since it was placed. Nothing that is
// computed depends on it; measures of the channel and of the depth do.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace quicksand {

struct World;

struct IntruderTrajectory {
  std::vector<Vec2> places;  // of its centre, the first where it was placed, not wrapped [d]
  double surface = 0;        // top of the packing when it was placed [d]
};

// Adds the place where the intruder is, if it has moved by more than a quarter of its radius since the
// last one, and the packing's top with the first. Does nothing where there is no intruder. To be
// called before each step: then the first place is the one where it was put.
void record_trajectory(World& world);

// The trajectory up to the present place, which is its last. An intruder that nobody recorded was placed where
// it is. No places where there is no intruder.
IntruderTrajectory trajectory_so_far(const World& world);

// Distance of each disk's centre from where the intruder has passed, through the nearest periodic image (nd) [d]; where
// it is not below `at_most`, or there is no trajectory, `at_most`. A disk has passed along the trajectory. A taller
// body has passed with its upright axis, as it was placed: disks of its half_width() along that reach from its highest
// to its lowest point.
std::vector<double> distances_from_trajectory(const World& world, double at_most);

}  // namespace quicksand
