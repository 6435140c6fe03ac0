// What the searches push with a threshold, pull, shear and adiabatic deposition share.
#include "core/phases/search.h"

#include <cmath>

#include "core/measures/critical_force.h"
#include "core/phases/protocol.h"
#include "core/world/extent.h"

namespace quicksand {

SearchKind search_kind(const Phase& phase) {
  if (std::holds_alternative<PullPhase>(phase.kind)) return SearchKind::pull;
  if (std::holds_alternative<ShearPhase>(phase.kind)) return SearchKind::shear;
  const auto* push = std::get_if<PushPhase>(&phase.kind);
  if (push && push->threshold) return SearchKind::push;
  const auto* deposit = std::get_if<DepositPhase>(&phase.kind);
  return deposit && deposit->adiabatic ? SearchKind::adiabatic : SearchKind::none;
}

SearchTrials threshold_trials(const PushPhase& push) {
  return {.first_force = push.force,
          .tolerance = push.threshold.value_or(Threshold{}).tolerance,
          .rest_speed = push.rest_speed,
          .rest_time = push.rest_time,
          .max_time = push.max_time};
}

void Protocol::begin_search(SearchKind kind) {
  state_.search = {};
  state_.search.kind = kind;
  state_.search.base = std::make_shared<const World>(world_);
}

void Protocol::return_to_base() {
  const double time = world_.time;
  const std::int64_t step = world_.step;
  world_ = *state_.search.base;
  world_.time = time;
  world_.step = step;
}

void Protocol::begin_trial() {
  return_to_base();
  state_.search.trial_runs = true;
  state_.trial_start = world_.time;
  state_.rest_since = -1;
}

void Protocol::begin_force_trial(const Vec2& direction) {
  Search& search = state_.search;
  if (search.trial_runs || search.targets.empty()) return;
  begin_trial();
  ++search.trial;
  search.force = search.bracket.next();
  const Vec2 force = search.force * direction;
  world_.disks.applied[search.targets.front().body] = {force.x(), force.y(), 0};
}

bool Protocol::search_is_over(const SearchTrials& trials, bool moved, RestOf until) {
  Search& search = state_.search;
  if (search.trial_runs && world_.time > state_.trial_start) {
    const bool rests =
        until == RestOf::all
            ? at_rest(trials.rest_speed, trials.rest_time)
            // A body at rest may still be given way by what breaks around it.
            : rested(report_.bonds_broken == 0 &&
                         world_.disks.velocity[search.targets.front().body].head<2>().norm() <=
                             trials.rest_speed,
                     trials.rest_time);
    if (moved || rests || lasted(trials.max_time)) {
      search.trial_runs = false;
      if (!moved && !rests) ++search.undecided;
      search.bracket.record(moved, rests);
      if (search.bracket.done(trials.tolerance)) finish_target();
    }
  }
  if (!search.targets.empty()) return false;
  return_to_base();
  return true;
}

void Protocol::finish_target() {
  Search& search = state_.search;
  const World& base = *search.base;
  const SearchTarget& target = search.targets.front();
  const Vec2& centre = base.disks.position[target.body];
  state_.critical_forces.push_back({.phase = state_.phase,
                                    .kind = search.kind,
                                    .body = target.body,
                                    .position = {base.wrapped_x(centre.x()), centre.y()},
                                    .depth = target.depth,
                                    .weight_above = target.weight_above,
                                    .force_low = search.bracket.low,
                                    .force_held = search.bracket.held,
                                    .force_high = search.bracket.high,
                                    .trials = search.bracket.trials,
                                    .undecided = search.undecided});
  search.targets.erase(search.targets.begin());
  ++search.finished;
  search.bracket = {.first = search.bracket.first};
  search.undecided = 0;
}

double Protocol::search_progress(const SearchTrials& trials) const {
  const Search& search = state_.search;
  const double targets = search.finished + static_cast<double>(search.targets.size());
  if (targets == 0) return 1;
  // To find an interval [F, 2F], then to halve it.
  const double expected = 3 + std::max(0.0, std::log2(0.5 / trials.tolerance));
  return (search.finished + std::min(0.9, search.bracket.trials / expected)) / targets;
}

}  // namespace quicksand
