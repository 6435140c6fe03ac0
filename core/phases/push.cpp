// The phase "push": an intruder is pushed into the packing, or the smallest force is sought with which it enters.
#include "core/measures/critical_force.h"
#include "core/measures/measures.h"
#include "core/phases/protocol.h"
#include "core/world/ballistic.h"
#include "core/world/extent.h"

namespace quicksand {

// The intruder is the last disk as long as its phase lasts.
void Protocol::enter(const PushPhase& phase) {
  form_bonds(phase.bonding, phase.bonds);
  world_.bonds.mark_initial();
  const double radius = phase.diameter / 2;
  const double x = phase.x.value_or(world_.box.width / 2);
  const std::optional<Landing> landing = LandingSite(world_).land(x, radius);
  const Vec2 centre = landing ? landing->centre : Vec2(x, radius);
  const double top = packing_top(world_);
  const int intruder = world_.disks.add(
      {.position = centre, .radius = radius, .density = phase.density, .role = Role::intruder});
  if (!phase.threshold) {
    world_.disks.applied[intruder] = {0, -phase.force, 0};
    return;
  }
  begin_search(SearchKind::push);
  state_.search.bracket.first = phase.force;
  state_.search.targets = {{.body = intruder,
                            .depth = top - centre.y(),
                            .weight_above = weight_above(world_, centre.y())}};
}

void Protocol::before_step(const PushPhase&) {
  if (seeks_threshold()) begin_force_trial({0, -1});
}

bool Protocol::is_over(const PushPhase& phase) {
  const int intruder = world_.disks.size() - 1;
  if (!seeks_threshold()) {
    const bool rest = rests_of(phase.until, intruder, phase.rest_speed, phase.rest_time);
    return rest || lasted(phase.max_time);
  }
  const Search& search = state_.search;
  const double way =
      search.base->disks.position[intruder].y() - world_.disks.position[intruder].y();
  const bool entered =
      search.trial_runs && way >= phase.threshold->distance.value_or(phase.diameter);
  return search_is_over(threshold_trials(phase), entered, phase.until);
}

double Protocol::progress(const PushPhase& phase) const {
  if (seeks_threshold()) return search_progress(threshold_trials(phase));
  return (world_.time - state_.phase_start) / phase.max_time;
}

void Protocol::leave(const PushPhase& phase) {
  if (phase.release) world_.disks.applied.back() = {0, 0, 0};
}

}  // namespace quicksand
