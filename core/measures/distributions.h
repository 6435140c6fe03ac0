// How quantities are distributed over grains, contacts and height.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/forces/stress.h"
#include "core/measures/regions.h"
#include "core/world/world.h"

namespace quicksand {

// Counts of values in bins: bin k holds edges[k] <= value < edges[k + 1], the last one its upper edge too.
struct Histogram {
  std::vector<double> edges;          // (bins + 1), rising [unit of the values]
  std::vector<std::int64_t> counts;   // (bins)
  std::int64_t below = 0, above = 0;  // values outside the edges, in no bin

  // Count over that of all values, those outside included, and over the width of the bin (bins) [1 over
  // the unit of the values]; zeros if there are no values.
  std::vector<double> density() const;
};

std::vector<double> even_edges(double low, double high, int bins);
// Of equal ratio, this many bins a factor of ten: 10^low to 10^high, for whole powers.
std::vector<double> decade_edges(int low, int high, int bins_per_decade);
Histogram histogram(std::span<const double> values, std::vector<double> edges);

// Angles between active bonds of a grain that are neighbours around it, from 0 to pi [rad]. Walls and
// the intruder count as bonded neighbours. Of two neighbours that are more than pi apart the angle is
// not taken: other bonds of the grain, or the same angle from the other side, lie between. So two bonds
// have one angle, and z bonds z of them, or z - 1 if they leave one half-plane empty. Without edges,
// 35 even bins.
Histogram bond_angles(const World& world, std::vector<double> edges = {});

// Angle of the line between the centres of touching grains against the horizontal, 0 to pi/2 [rad].
Histogram contact_orientations(const World& world, std::span<const Pair> touching);

// How contacts between grains are directed: the tensor of the mean of n (x) n, whose trace is 1.
struct Fabric {
  double anisotropy =
      0;  // difference of its eigenvalues: 0 if all directions are equally frequent, 1 if there is one [1]
  double direction =
      0;  // of the larger one, in which contacts are most frequent, to +x, from 0 to pi [rad]
};
// Empty without such contacts.
std::optional<Fabric> fabric_of(const World& world, std::span<const Pair> touching);

// Compressive normal forces in the contacts of grains with grains and walls in the last step, over their
// mean, 1e-4 to 1e2, ten bins a factor of ten [1]. The intruder is left out, whose driving force would
// set the mean.
Histogram contact_forces(const World& world);

// Tensile normal forces in active bonds of grains with grains and walls in the last step, over the
// cohesion force, 1e-7 to 1, ten bins a factor of ten [1]: the weights that bonds carry at rest are
// small against what they hold.
Histogram bond_tensions(const World& world);

// One horizontal slice of the packing.
struct Slice {
  double low = 0, high = 0;               // [d]
  std::optional<double> volume_fraction;  // of everything in it; empty where the sides are open
  Region grains;                          // those with their centre in it
  std::optional<Stress> stress;           // of those, over its area; empty where room_width() is
};

// Slices of equal thickness [d] from a multiple of it, at packing_bottom() or below, to above the highest grain; none
// without grains. Throws InputError if that makes more than 10 000 slices.
std::vector<Slice> height_profile(const World& world, std::span<const Pair> touching,
                                  double thickness);

}  // namespace quicksand
