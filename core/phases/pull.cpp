// The phase "pull": the smallest upward force that takes the intruder out.
#include "core/measures/critical_force.h"
#include "core/measures/measures.h"
#include "core/phases/protocol.h"
#include "core/world/extent.h"

namespace quicksand {

void Protocol::enter(const PullPhase& phase) {
  form_bonds(false);
  begin_search(SearchKind::pull);
  Search& search = state_.search;
  search.bracket.first = phase.trials.first_force;
  const int intruder = world_.intruder();
  if (intruder < 0) return;
  const double height = world_.disks.position[intruder].y();
  search.targets = {{.body = intruder,
                     .depth = packing_top(world_) - height,
                     .weight_above = weight_above(world_, height)}};
}

void Protocol::before_step(const PullPhase&) { begin_force_trial({0, 1}); }

bool Protocol::is_over(const PullPhase& phase) {
  const Search& search = state_.search;
  if (!search.trial_runs) return search_is_over(phase.trials, false);
  const int intruder = search.targets.front().body;
  const double height = world_.disks.position[intruder].y();
  const Disks& before = search.base->disks;
  const bool out = phase.distance ? height >= before.position[intruder].y() + *phase.distance
                                  : height - before.radius[intruder] > packing_top(*search.base);
  return search_is_over(phase.trials, out, phase.trials.until);
}

double Protocol::progress(const PullPhase& phase) const { return search_progress(phase.trials); }

}  // namespace quicksand
