#include "core/shear_strength.h"

#include <algorithm>

namespace quicksand {

namespace {

StrengthAtDepth strength_at(std::span<const CriticalForce> forces, int phase, double depth) {
  StrengthAtDepth at{.depth = depth};
  std::vector<double> strengths;
  for (const CriticalForce& found : forces) {
    if (found.phase != phase || found.kind != SearchKind::shear || found.depth != depth) continue;
    at.weight_above = found.weight_above;
    if (found.force_high)
      strengths.push_back((found.force_low + *found.force_high) / 2);
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
  std::vector<double> depth, weight, mean, error;
  for (const double at : depths) {
    const StrengthAtDepth& found = result.depths.emplace_back(strength_at(forces, phase, at));
    if (!found.strength) continue;
    depth.push_back(at);
    weight.push_back(*found.weight_above);
    mean.push_back(found.strength->value);
    error.push_back(found.strength->error.value_or(0));
  }
  result.weighted = !error.empty() && std::ranges::min(error) > 0;
  const auto fit = [&](const std::vector<double>& x) {
    return result.weighted ? fit_line(x, mean, error) : fit_line(x, mean);
  };
  result.against_depth = fit(depth);
  result.against_weight = fit(weight);
  return result;
}

}  // namespace quicksand
