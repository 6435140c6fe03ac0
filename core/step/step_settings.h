// How a step is taken.
#pragma once

#include <cstdint>
#include <optional>

#include "core/sweeps/nscd_settings.h"

namespace quicksand {

// When a bond breaks: `energy` see energy_criterion.h, and whenever the gap at the end of the step passes the
// range. `linearised`: only the latter, the gap taken along the normal at the start of the step (with
// the curvature term). `geometric`: the same with the distance after the straight move; it breaks bonds whose
// turning changes within the step, without the curvature term all that turn, and is there to show it.
enum class FailureCriterion : std::uint8_t { energy, linearised, geometric };

struct StepSettings {
  // Engaged: the scheme of the step is NSCD. Absent: every step is solved to the solver's tolerance.
  std::optional<Nscd> nscd;
  double dt = 1e-2;  // [sqrt(d/g)]
  FailureCriterion break_rule = FailureCriterion::energy;
  bool curvature_term = true;  // second-order gap of bonded contacts
  // Engaged: the step is dt divided by the power of two that lets no bonded pair turn farther in it
  // than this [rad]. Absent: every step is dt.
  std::optional<double> max_turn;
  // An unconverged step is not taken but tried again as two of half the length, and so on up to
  // max_halvings times; then the run stops. false: it is taken and counted, and breaks no bond.
  bool stop_if_unconverged = true;
  int max_halvings = 8;
  bool operator==(const StepSettings&) const = default;
};

// What choosing NSCD sets, as its literature has it: one time step, bonds that fail by their gap after the straight
// move, whether the step converged or not.
inline StepSettings nscd_step() {
  return {.nscd = Nscd{},
          .dt = 1e-3,
          .break_rule = FailureCriterion::geometric,
          .curvature_term = false,
          .stop_if_unconverged = false};
}

}  // namespace quicksand
