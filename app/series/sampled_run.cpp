#include "app/series/sampled_run.h"

#include <algorithm>
#include <utility>

namespace quicksand {

SampledRun::SampledRun(const Scenario& scenario, Checkpoint start, std::optional<double> every,
                       Sink sink)
    : protocol_(scenario, std::move(start.world), start.protocol),
      every_(every),
      sink_(std::move(sink)),
      phase_index_(protocol_.state().phase) {}

void SampledRun::go_on(const SamplesSoFar& samples) {
  samples_ = samples;
  if (samples_.step == world().step) samples_.last.sample = measure(world());
}

std::string SampledRun::phase_name() const {
  const Phase* phase = protocol_.phase();
  return phase != nullptr ? std::string(quicksand::phase_name(*phase)) : std::string("end");
}

Progress SampledRun::advance() {
  if (samples_.step < 0) sample();
  const ProtocolState before = protocol_.state();
  const std::int64_t step_before = world().step;
  const double time_before = world().time;
  if (protocol_.phase() != nullptr && (before.phase != times_of_ || !before.entered)) {
    times_ =
        SampleTimes(before.entered ? before.phase_start : time_before,
                    sample_interval(protocol_.scenario(), *protocol_.phase(), every_), time_before);
    times_of_ = before.phase;
  }
  samples_.phase = phase_name();
  phase_index_ = before.phase;
  const Progress progress = advance_protocol();
  if (progress == Progress::given_up) return progress;
  if (world().step != step_before) count(before, world().time - time_before);
  if (times_.due(world().time) || progress == Progress::phase_ended) sample();
  return progress;
}

Progress SampledRun::advance_protocol() {
  try {
    return protocol_.advance();
  } catch (const InputError& error) {
    throw PhaseRefused(error);
  }
}

void SampledRun::sample_every(std::optional<double> every) {
  every_ = every;
  times_of_ = -1;
}

namespace {

// Of the present phase, a slide. [F_g sqrt(d/g)]
double shear_impulse(const ProtocolState& state) {
  const auto found = state.memory.find(kShearImpulse);
  return found == state.memory.end() ? 0 : found->second;
}

}  // namespace

void SampledRun::count(const ProtocolState& before, double time) {
  const ProtocolState& now = protocol_.state();
  const SolveReport& solve = protocol_.last_step().solve;
  Row& pending = samples_.pending;
  pending.residual = std::max(pending.residual, solve.residual.natural);
  pending.gap_error = std::max(pending.gap_error, solve.residual.gap);
  pending.velocity_change = std::max(pending.velocity_change, solve.velocity_change.value_or(0));
  pending.iterations += now.iterations - before.iterations;
  pending.factorisations += now.factorisations - before.factorisations;
  pending.trial = now.search.trial;
  pending.trial_force = now.search.force;
  if (samples_.phase == SlidePhase::kName) {
    pending.shear_impulse += shear_impulse(now) - (before.entered ? shear_impulse(before) : 0);
    pending.shear_time += time;
  }
  pending.unconverged += now.unconverged_steps - before.unconverged_steps;
}

void SampledRun::sample() {
  const bool first = samples_.step < 0;
  if (!first && samples_.step == world().step && samples_.bodies == world().disks.size() &&
      samples_.healed == world().bonds.healed)
    return;
  if (first) samples_.phase = phase_name();
  samples_.last = std::exchange(samples_.pending, {});
  {
    const WorkClock::Span span(&protocol_.clock(), Work::measures);
    samples_.last.sample = measure(world());
  }
  samples_.last.phase = samples_.phase;
  samples_.last.take_energy(protocol_.state());
  samples_.step = world().step;
  samples_.bodies = world().disks.size();
  samples_.healed = world().bonds.healed;
  sink_(samples_.last, world());
}

}  // namespace quicksand
