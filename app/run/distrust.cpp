#include "app/run/distrust.h"

#include <algorithm>

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
  return reasons;
}

}  // namespace quicksand
