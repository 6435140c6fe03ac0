// Strength of a packing over depth, from the critical forces of a shear phase.
//
// The strength of a grain is the middle of its interval. Grains that no force moved are counted, but
// are not in the means. The lines go through the strengths of all grains, with equal weights: standard errors of a
// few grains a depth are too uncertain to weight by (with two, a line's own would be three times too small).
#pragma once

#include <span>
#include <vector>

#include "core/measures/critical_force.h"
#include "core/measures/linear_fit.h"

namespace quicksand {

struct StrengthAtDepth {
  double depth = 0;                         // below the packing top [d]
  int grains = 0;                           // in the mean
  int never_moved = 0;                      // not in it
  std::optional<Mean> strength = {};        // [F_g]
  std::optional<double> weight_above = {};  // of all grains above [F_g]; empty if none was drawn
};

struct ShearStrength {
  std::vector<StrengthAtDepth> depths;      // in the order given
  std::optional<Line> against_depth = {};   // [F_g/d], [F_g]; empty unless two depths have means
  std::optional<Line> against_weight = {};  // slope: the effective friction [1]
};

// The forces of one phase, at the depths of that phase.
ShearStrength shear_strength(std::span<const CriticalForce> forces, int phase,
                             std::span<const double> depths);

}  // namespace quicksand
