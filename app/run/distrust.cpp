#include "app/run/distrust.h"

#include <algorithm>
#include <cmath>

#include "app/json/json_reader.h"

namespace quicksand {

double worst_overlap(const ProtocolState& state, double present_overlap) {
  return std::max(state.worst_overlap, present_overlap);
}

std::string distrust(const ProtocolState& state, double present_overlap,
                     const StrictBounds& bounds) {
  std::string reasons;
  const auto add = [&](const std::string& reason) {
    reasons += (reasons.empty() ? "" : ", ") + reason;
  };
  if (state.unconverged_steps > 0)
    add(std::to_string(state.unconverged_steps) + " steps did not converge (worst residual " +
        number_text(state.worst_residual) + ")");
  if (state.broken_in_unconverged > 0)
    add(std::to_string(state.broken_in_unconverged) + " bonds broke in them");
  const double overlap = worst_overlap(state, present_overlap);
  // Also true for what is not a number.
  if (!(overlap <= bounds.max_overlap))
    add("two bodies overlapped by " + number_text(overlap) + " d, more than the " +
        number_text(bounds.max_overlap) + " d that are accepted");
  // Exact contacts only dissipate. Collapses, pistons and searches gain up to 1e-2 of it by overlaps that are pushed
  // out; the least is what rounding does to bodies at rest.
  constexpr double kMostGained = 0.05, kLeast = 1e-6;  // [1], [F_g d]
  const double turned_over = std::abs(state.external_work) + state.energy_dissipated;
  if (!(state.energy_gained <= std::max(kMostGained * turned_over, kLeast)))
    add("steps gained an energy of " + number_text(state.energy_gained) + " F_g d, more than " +
        number_text(kMostGained) + " of what was worked and dissipated (" +
        number_text(turned_over) + " F_g d)");
  return reasons;
}

}  // namespace quicksand
