#include "app/run_folder/validation.h"

#include <algorithm>
#include <cmath>

#include "app/json/json_reader.h"
#include "core/base/format.h"

namespace quicksand {

double worst_overlap(const ProtocolState& state, double present_overlap) {
  return std::max(state.worst_overlap, present_overlap);
}

std::string nscd_note(const Scenario& scenario, const ProtocolState& state, std::int64_t steps) {
  if (!scenario.step.nscd) return {};
  const SweepErrors& errors = state.sweep_errors;
  const auto spread = [](const LogHistogram& h, const char* unit) {
    return format("median %.1e, 99 %% below %.1e, worst %.1e%s", h.quantile(0.5), h.quantile(0.99),
                  h.largest, unit);
  };
  return "standard nonsmooth contact dynamics (nscd), " +
         count_text(scenario.step.nscd->sweeps, "sweep") +
         " a step: " + std::to_string(state.unconverged_steps) + " of " + std::to_string(steps) +
         " steps did not converge to " + number_text(scenario.solver.tolerance) + " and " +
         count_text(state.broken_in_unconverged, "bond") +
         " failed in them, as is inherent in the method; residual " + spread(errors.residual, "") +
         "; gap of bonds " + spread(errors.bond_gap, " d") + "; overlap " +
         spread(errors.penetration, " d") + ". The results depend on sweeps and time step";
}

std::string validation_failures(const ProtocolState& state, const Sample& now,
                                const StrictBounds& bounds) {
  std::string reasons;
  const auto add = [&](const std::string& reason) {
    reasons += (reasons.empty() ? "" : ", ") + reason;
  };
  if (state.unconverged_steps > 0)
    add(count_text(state.unconverged_steps, "step") + " did not converge (worst residual " +
        number_text(state.worst_residual) + ")");
  if (state.broken_in_unconverged > 0)
    add(count_text(state.broken_in_unconverged, "bond") + " broke in them");
  const double overlap = worst_overlap(state, now.max_overlap);
  // Also true for what is not a number.
  if (!(overlap <= bounds.max_overlap))
    add("two bodies overlapped by " + number_text(overlap) + " d, more than the " +
        number_text(bounds.max_overlap) + " d that are accepted");
  if (!(state.worst_bond_gap <= bounds.max_overlap))
    add("a bond was left open by " + number_text(state.worst_bond_gap) +
        " d beyond its range, more than the " + number_text(bounds.max_overlap) +
        " d that are accepted (step.max_turn shortens steps in which pairs rotate far)");
  // Exact contacts only dissipate. Collapses and pistons gain up to 1e-4 of it by overlaps that are pushed out, a bonded
  // pair that begins to turn by 0.5 rad a step 0.05 of its own; the least is what rounding does to bodies at rest.
  constexpr double kMostGained = 0.05, kLeast = 1e-6;  // [1], [F_g d]
  const double turned_over = std::abs(state.external_work) + state.energy_dissipated +
                             now.energy.kinetic + now.energy.rotational;
  if (!(state.energy_gained <= std::max(kMostGained * turned_over, kLeast)))
    add("steps gained an energy of " + number_text(state.energy_gained) + " F_g d, more than " +
        number_text(kMostGained) +
        " of the work done, the energy dissipated and the kinetic energy (" +
        number_text(turned_over) + " F_g d)");
  return reasons;
}

}  // namespace quicksand
