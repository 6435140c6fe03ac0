// Where the phases of a scene stand, and what they have found.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/measures/critical_force.h"
#include "core/measures/drive_result.h"
#include "core/protocol/force_bracket.h"
#include "core/sweeps/nscd.h"
#include "core/world/world.h"

namespace quicksand {

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
  double interval = 0;                // adiabatic: between the grains of this specimen [sqrt(d/g)]
  std::int64_t breaks = 0;            // Bonds::broken as last looked at
  double last_break = -1;             // when it was found changed in this trial [sqrt(d/g)]
};

// One specimen of an adiabatic deposition.
struct AdiabaticDeposit {
  int phase = 0;               // index
  double interval = 0;         // between grains [sqrt(d/g)]
  double volume_fraction = 0;  // as Sample::volume_fraction [1]
  double coordination = 0;     // as Sample::coordination [1]
  std::int64_t grains = 0;     // as Sample::grains
  std::optional<double> change =
      {};  // of the volume fraction since the last specimen, relative [1]

  bool operator==(const AdiabaticDeposit&) const = default;
};

// In the memory of a slide: horizontal force of the piston on the bodies, positive towards +x, times time, since the phase
// began. [F_g sqrt(d/g)]
inline constexpr const char* kShearImpulse = "shear_impulse";

// Where a protocol stands; with the world, all that a restart needs.
struct ProtocolState {
  int phase = 0;           // index of the present phase; number of phases when finished
  bool entered = false;    // whether the present phase has been set up
  double phase_start = 0;  // world time at its beginning [sqrt(d/g)]
  double trial_start = 0;  // ... at the beginning of its present trial, if it is a search
  // What the present phase has to remember besides: numbers by names of its own, empty at its beginning.
  std::map<std::string, double> memory;
  double rest_since = -1;  // at rest since then; negative: not at rest
  Search search;           // if the present phase is one
  // Counted over the whole run.
  std::int64_t unconverged_steps = 0;  // taken although they did not converge
  std::int64_t halved_steps = 0;       // not taken but tried again as two halves
  std::int64_t broken_in_unconverged = 0;
  std::int64_t breaks_withheld = 0;
  std::int64_t iterations = 0;
  std::int64_t factorisations = 0;
  double worst_residual = 0;  // Residual::natural
  double worst_overlap = 0;   // of two bodies, where a step began [d]
  double worst_bond_gap = 0;  // by which a bond that lasts was open beyond its range, likewise [d]
  // EnergyBalance of all steps [F_g d].
  double external_work = 0;
  double energy_dissipated = 0;
  double energy_gained = 0;  // by steps that ended with more than they began with and received
  SweepErrors sweep_errors;  // of the steps by NSCD
  // Found over the whole run.
  std::vector<CriticalForce> critical_forces;
  std::vector<AdiabaticDeposit> adiabatic_deposits;
  std::vector<DriveResult> drive_results;
};

}  // namespace quicksand
