// What all phases share that repeat trials: searches for a force or torque, and adiabatic deposition.
#include "core/protocol/search.h"

#include <cmath>
#include <utility>

#include "core/protocol/running_phase.h"
#include "core/scene/make_world.h"
#include "core/world/extent.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

SearchKind search_kind(const Phase& phase) { return running(phase)->searches_for(); }

void begin_search(Stage& stage, SearchKind kind) {
  stage.state.search = {};
  stage.state.search.kind = kind;
  stage.state.search.base = std::make_shared<const World>(stage.world);
}

void begin_search_on(Stage& stage, SearchKind kind, int body, double first) {
  begin_search(stage, kind);
  const World& world = stage.world;
  const double height = world.disks.position[body].y();
  stage.state.search.bracket.first = first;
  stage.state.search.targets = {{.body = body,
                                 .depth = packing_top(world) - height,
                                 .weight_above = weight_above(world, height)}};
}

void return_to_base(Stage& stage) {
  const double time = stage.world.time;
  const std::int64_t step = stage.world.step;
  // What the trial has added gives its rows to what the next one adds.
  const bool replaced = stage.world.disks.size() != stage.state.search.base->disks.size();
  if (replaced) become_another_specimen(stage.world);
  const std::int64_t specimen = stage.world.specimen;
  stage.world = *stage.state.search.base;
  stage.world.time = time;
  stage.world.step = step;
  stage.world.specimen = specimen;
}

void begin_trial(Stage& stage) {
  return_to_base(stage);
  stage.state.search.trial_runs = true;
  stage.state.search.breaks = stage.world.bonds.broken;
  stage.state.search.last_break = -1;
  stage.state.trial_start = stage.world.time;
  stage.state.rest_since = -1;
}

void begin_force_trial(Stage& stage, const Vec3& direction) {
  Search& search = stage.state.search;
  if (search.trial_runs || search.targets.empty()) return;
  begin_trial(stage);
  ++search.trial;
  search.force = search.bracket.next();
  stage.world.disks.applied[search.targets.front().body] = search.force * direction;
}

namespace {

// A body at rest may still be given way by what breaks around it.
bool broke_in_last_step(Stage& stage) {
  Search& search = stage.state.search;
  if (std::exchange(search.breaks, stage.world.bonds.broken) != stage.world.bonds.broken)
    search.last_break = stage.world.time;
  return search.last_break == stage.world.time;
}

// The spin of a disk matters only where it is what is to be turned.
double speed_of(const World& world, int body, SearchKind kind) {
  return kind == SearchKind::vane ? fastest_point(world, body) : speed_of_body(world, body);
}

void finish_target(ProtocolState& state) {
  Search& search = state.search;
  const World& base = *search.base;
  const SearchTarget& target = search.targets.front();
  const Vec2& centre = base.disks.position[target.body];
  state.critical_forces.push_back({.phase = state.phase,
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

}  // namespace

bool search_is_over(Stage& stage, const SearchTrials& trials, bool moved, RestOf until) {
  Search& search = stage.state.search;
  if (search.trial_runs && stage.world.time > stage.state.trial_start) {
    const bool rests = until == RestOf::all
                           ? stage.at_rest(trials.rest_speed, trials.rest_time)
                           : stage.rested(!broke_in_last_step(stage) &&
                                              speed_of(stage.world, search.targets.front().body,
                                                       search.kind) <= trials.rest_speed,
                                          trials.rest_time);
    if (moved || rests || stage.lasted(trials.max_time)) {
      search.trial_runs = false;
      if (!moved && !rests) ++search.undecided;
      search.bracket.record(moved, rests);
      if (search.bracket.done(trials.tolerance)) finish_target(stage.state);
    }
  }
  if (!search.targets.empty()) return false;
  return_to_base(stage);
  return true;
}

void take_laws_in_search(Stage& stage, const Scenario& scenario) {
  Search& search = stage.state.search;
  World base = *search.base;
  take_laws(base, scenario);
  base.bonding = stage.world.bonding;
  base.rebonding = stage.world.rebonding;
  if (same_but_for_time(base, *search.base)) return;
  search.base = std::make_shared<const World>(std::move(base));
  search.trial_runs = false;
  search.bracket = {.first = search.bracket.first};
  search.undecided = 0;
}

double search_progress(const Stage& stage, const SearchTrials& trials) {
  const Search& search = stage.state.search;
  const double targets = search.finished + static_cast<double>(search.targets.size());
  if (targets == 0) return 1;
  // To find an interval [F, 2F], then to halve it.
  const double expected = 3 + std::max(0.0, std::log2(0.5 / trials.tolerance));
  return (search.finished + std::min(0.9, search.bracket.trials / expected)) / targets;
}

}  // namespace quicksand
