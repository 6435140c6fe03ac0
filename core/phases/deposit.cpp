// The phase "deposit": grains fall one by one and stick where they touch.
#include <algorithm>

#include "core/measures/critical_force.h"
#include "core/measures/measures.h"
#include "core/phases/protocol.h"
#include "core/scene/grain_sizes.h"
#include "core/world/ballistic.h"
#include "core/world/extent.h"

namespace quicksand {

void Protocol::enter(const DepositPhase& phase) {
  form_bonds(true, phase.bonds);
  if (phase.adiabatic) {
    begin_search(SearchKind::adiabatic);
    state_.search.interval = phase.interval;
  }
  begin_sample(phase);
}

void Protocol::begin_sample(const DepositPhase& phase) {
  if (phase.adiabatic) begin_trial();
  state_.dropped = 0;
  state_.full = false;
  state_.next_drop = world_.time;
}

double Protocol::interval(const DepositPhase& phase) const {
  return phase.adiabatic ? state_.search.interval : phase.interval;
}

// Drops one grain at a random place, to which it may bond; false if there is no place left below the
// height.
bool Protocol::drop_grain(const DepositPhase& phase, LandingSite& site, std::vector<Pair>& bonded) {
  double radius = 0.5;
  if (phase.polydispersity) {
    const double before_cut = deviation_before_cut(phase.polydispersity->deviation);
    radius = draw_diameter(world_.random, before_cut) / 2;
  }
  const Box& box = world_.box;
  const double margin = box.sides == Sides::walls ? radius : 0;
  // A surface is never flat: the packing is full when as many grains in a row as the box is wide
  // found no place.
  const int tries = phase.height > 0 ? std::max(10, static_cast<int>(box.width)) : 1;
  for (int k = 0; k < tries; ++k) {
    const double x = margin + world_.random.uniform() * (box.width - 2 * margin);
    const std::optional<Landing> landing = site.land(x, radius, phase.capture_radius);
    if (!landing || (phase.height > 0 && landing->centre.y() + radius > phase.height)) continue;
    const int grain = world_.disks.add(
        {.position = landing->centre, .radius = radius, .velocity = {0, -phase.drop_velocity}});
    site.add(grain);
    const int touched = landing->touched;
    const Pair pair = is_wall(touched) ? Pair{grain, touched} : Pair{touched, grain};
    if (world_.law(pair).cohesion_force) bonded.push_back(pair);
    ++state_.dropped;
    return true;
  }
  return false;
}

void Protocol::before_step(const DepositPhase& phase) {
  if (phase.adiabatic && !state_.search.trial_runs) begin_sample(phase);
  const auto drops = [&] {
    return !state_.full && (phase.grains == 0 || state_.dropped < phase.grains) &&
           due(state_.next_drop);
  };
  if (!drops()) return;
  LandingSite site(world_);
  std::vector<Pair> bonded;
  for (; drops(); state_.next_drop += interval(phase))
    state_.full = !drop_grain(phase, site, bonded);
  std::ranges::sort(bonded);
  world_.bonds.form(bonded);
}

bool Protocol::is_over(const DepositPhase& phase) {
  const bool all = state_.full || (phase.grains > 0 && state_.dropped >= phase.grains);
  if (!all || !due(state_.next_drop)) return false;
  return !phase.adiabatic || adiabatic_is_over(*phase.adiabatic);
}

double Protocol::progress(const DepositPhase& phase) const {
  const double of_sample =
      phase.grains > 0 ? static_cast<double>(state_.dropped) / static_cast<double>(phase.grains)
                       : packing_top(world_) / phase.height;
  return phase.adiabatic ? adiabatic_progress(phase, std::min(1.0, of_sample)) : of_sample;
}

}  // namespace quicksand
