// How quantities are distributed over grains, contacts and height.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/regions.h"
#include "core/world.h"

namespace quicksand {

// Counts of values in bins of equal width: bin k holds edges[k] <= value < edges[k + 1], the last one
// its upper edge too.
struct Histogram {
  std::vector<double> edges;         // (bins + 1) [unit of the values]
  std::vector<std::int64_t> counts;  // (bins)
  std::int64_t beyond = 0;           // values above the last edge, in no bin

  // Count over that of all values, those beyond included, and over the width of the bin (bins) [1 over
  // the unit of the values]; zeros if there are no values.
  std::vector<double> density() const;
};

// `values` must not be below `low`.
Histogram histogram(std::span<const double> values, double low, double high, int bins);

// Angles between active bonds of a grain that are neighbours around it, from 0 to pi [rad]. Walls and
// the intruder count as bonded neighbours. Of two neighbours that are more than pi apart the angle is
// not taken: other bonds of the grain, or the same angle from the other side, lie between. So two bonds
// have one angle, and z bonds z of them, or z - 1 if they leave one half-plane empty.
Histogram bond_angles(const World& world);

// Angle of the line between the centres of touching grains against the horizontal, 0 to pi/2 [rad].
Histogram contact_orientations(const World& world, std::span<const Pair> touching);

// Compressive normal forces in the contacts of grains with grains and walls in the last step, over their
// mean, up to 10 [1]. The intruder is left out, whose driving force would set the mean.
Histogram contact_forces(const World& world);

// Tensile normal forces in active bonds of grains with grains and walls in the last step, over the
// cohesion force, 0 to 1 [1].
Histogram bond_tensions(const World& world);

// One horizontal slice of the sample.
struct Slice {
  double low = 0, high = 0;               // [d]
  std::optional<double> volume_fraction;  // of everything in it; empty in a box without a width
  Region grains;                          // those with their centre in it
};

// Slices of equal thickness [d] from the floor, or without one from a multiple of the thickness below
// the lowest grain, to above the highest grain; none without grains. Throws InputError if that makes
// more than 10 000 slices.
std::vector<Slice> height_profile(const World& world, std::span<const Pair> touching,
                                  double thickness);

}  // namespace quicksand
