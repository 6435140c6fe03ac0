// Searches by repeated trials from one stored state, and what they found.
//
// A trial begins with the bodies, bonds and contacts as they were when the phase was entered (the base);
// only the clock (time and number of steps) goes on, so that series and frames stay in order. The phase
// ends with the base, too.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/measures/critical_force.h"
#include "core/phases/force_bracket.h"
#include "core/scene/phases.h"
#include "core/world/world.h"

namespace quicksand {

// What the phase searches for.
SearchKind search_kind(const Phase& phase);
// Whether it is a critical force.
constexpr bool is_of_force(SearchKind kind) {
  return kind == SearchKind::pull || kind == SearchKind::shear || kind == SearchKind::push;
}

// The trials of a push that seeks its threshold.
SearchTrials threshold_trials(const PushPhase& push);

// A body whose critical force is sought.
struct SearchTarget {
  int body = 0;
  double depth = 0;         // below the packing top of the base [d]
  double weight_above = 0;  // of all grains whose centres are above that depth [F_g]
};

// Where the search of the present phase stands.
struct Search {
  SearchKind kind = SearchKind::none;
  std::shared_ptr<const World> base;  // null: no search
  bool trial_runs = false;            // false: the next step begins a trial
  std::vector<SearchTarget> targets;  // not yet finished, the present one first
  int finished = 0;                   // number of targets
  int trial = 0;                      // number of the present or last trial of the phase, from 1
  double force = 0;                   // on the target in it [F_g]
  ForceBracket bracket;               // of the present target
  int undecided = 0;                  // trials of the present target
  double interval = 0;                // adiabatic: between the grains of this sample [sqrt(d/g)]
};

// One sample of an adiabatic deposition.
struct AdiabaticDeposit {
  int phase = 0;                      // index
  double interval = 0;                // between grains [sqrt(d/g)]
  double volume_fraction = 0;         // as Sample::volume_fraction [1]
  double coordination = 0;            // as Sample::coordination [1]
  std::int64_t grains = 0;            // as Sample::grains
  std::optional<double> change = {};  // of the volume fraction since the last sample, relative [1]

  bool operator==(const AdiabaticDeposit&) const = default;
};

}  // namespace quicksand
