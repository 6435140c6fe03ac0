#include "core/measures/shear_strength.h"

#include "core/measures/critical_force.h"

namespace quicksand {

namespace {

double middle(const CriticalForce& found) { return (found.force_low + *found.force_high) / 2; }

StrengthAtDepth strength_at(std::span<const CriticalForce> forces, int phase, double depth) {
  StrengthAtDepth at{.depth = depth};
  std::vector<double> strengths;
  for (const CriticalForce& found : forces) {
    if (found.phase != phase || found.kind != SearchKind::shear || found.depth != depth) continue;
    at.weight_above = found.weight_above;
    if (found.force_high)
      strengths.push_back(middle(found));
    else
      ++at.never_moved;
  }
  at.grains = static_cast<int>(strengths.size());
  at.strength = mean_of(strengths);
  return at;
}

}  // namespace

ShearStrength shear_strength(std::span<const CriticalForce> forces, int phase,
                             std::span<const double> depths) {
  ShearStrength result;
  for (const double at : depths) result.depths.push_back(strength_at(forces, phase, at));
  std::vector<double> depth, weight, strength;
  for (const CriticalForce& found : forces) {
    if (found.phase != phase || found.kind != SearchKind::shear || !found.force_high) continue;
    depth.push_back(found.depth);
    weight.push_back(found.weight_above);
    strength.push_back(middle(found));
  }
  result.against_depth = fit_line(depth, strength);
  result.against_weight = fit_line(weight, strength);
  return result;
}

}  // namespace quicksand
