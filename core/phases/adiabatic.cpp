// The phase "deposit", adiabatic: whole samples, each slower than the last, until the volume fraction
// no longer changes.
//
// Every sample begins with the same random numbers, so that two of them differ by the interval alone.
#include <cmath>

#include "core/measures/measures.h"
#include "core/phases/protocol.h"

namespace quicksand {

namespace {

// The interval after this one; empty if that would be too long.
std::optional<double> longer(const Adiabatic& adiabatic, double interval) {
  constexpr double kRounding = 1e-9;
  const double next = interval * adiabatic.factor;
  return next <= adiabatic.max_interval * (1 + kRounding) ? std::optional(next) : std::nullopt;
}

}  // namespace

// The present sample is complete: records it; true if it was the last.
bool Protocol::adiabatic_is_over(const Adiabatic& adiabatic) {
  Search& search = state_.search;
  if (!search.trial_runs) return false;
  search.trial_runs = false;
  const Sample sample = measure(world_);
  AdiabaticDeposit now{.phase = state_.phase,
                       .interval = search.interval,
                       .volume_fraction = sample.volume_fraction,
                       .coordination = sample.coordination,
                       .grains = sample.grains};
  if (search.finished > 0) {
    const double before = state_.adiabatic_deposits.back().volume_fraction;
    if (before > 0) now.change = (now.volume_fraction - before) / before;
  }
  state_.adiabatic_deposits.push_back(now);
  ++search.finished;
  const std::optional<double> next = longer(adiabatic, search.interval);
  if (!next || (now.change && std::abs(*now.change) < adiabatic.tolerance)) return true;
  search.interval = *next;
  return false;
}

// By the time of all samples, if the longest interval is needed.
double Protocol::adiabatic_progress(const DepositPhase& phase, double of_sample) const {
  const Search& search = state_.search;
  double done = search.trial_runs ? of_sample * search.interval : 0, all = 0;
  for (std::optional<double> interval = phase.interval; interval;
       interval = longer(*phase.adiabatic, *interval)) {
    all += *interval;
    if (*interval < search.interval) done += *interval;
  }
  return done / all;
}

}  // namespace quicksand
