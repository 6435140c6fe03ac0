#include "app/session/finding.h"

#include "core/base/format.h"

namespace quicksand {

std::string newest_critical_force(const Session& session) {
  if (!session.loaded() || session.timeline() != nullptr) return {};
  const std::vector<CriticalForce>& found = session.protocol().state().critical_forces;
  if (found.empty()) return {};
  const CriticalForce& newest = found.back();
  const std::string unit = newest.kind == SearchKind::vane ? " F_g d" : " F_g";
  // An interval is known to a hundredth at best, so that three digits would not tell its ends apart.
  const auto text = [](double force) { return format("%.4g", force); };
  if (!newest.force_high) return "above " + text(newest.force_low) + unit;
  if (newest.force_low == 0) return "below " + text(*newest.force_high) + unit;
  return text(newest.force_low) + " to " + text(*newest.force_high) + unit;
}

}  // namespace quicksand
