// When samples are taken: at the start of a run, at the end of each phase, and in between at multiples
// of a fixed interval since the phase's beginning, so that a continued run samples at the same times.
#pragma once

#include <cstdint>
#include <optional>

#include "core/scene/scenario.h"

namespace quicksand {

// Time between samples of a phase [sqrt(d/g)]: `every` if given, else the phase's sample_every, else
// 1/100 of what a phase takes: of the grains times their interval for a deposit, of max_time for a
// settle that is not ended by rest or a scene without gravity, and 1/10 of the free fall through the
// box for what ends at rest (the collapse itself takes about ten of those). An adiabatic deposit counts
// with its longest interval, a pull with the max_time of a trial, and a shear, whose trials are many, has
// at most one sample a trial.
double sample_interval(const Scenario& scenario, const Phase& phase, std::optional<double> every);

// Number of grains that a deposit phase brings, from its number or height. An estimate in the latter
// case: volume fraction 0.37 with cohesion, 0.8 without.
std::int64_t estimated_grains(const Scenario& scenario, const DepositPhase& phase);

class SampleTimes {
 public:
  // Of a phase that began at `start`, after time `now`.
  SampleTimes(double start, double interval, double now);

  // Whether a sample is due; if so, the next is after `now`.
  bool due(double now);

 private:
  double start_;
  double interval_;
  std::int64_t next_;  // number of the next sample
};

}  // namespace quicksand
