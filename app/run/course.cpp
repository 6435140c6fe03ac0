#include "app/run/course.h"

#include <algorithm>
#include <utility>

namespace quicksand {

Course::Course(const Scenario& scenario, Checkpoint start, std::optional<double> every, Sink sink)
    : protocol_(scenario, std::move(start.world), start.protocol),
      every_(every),
      sink_(std::move(sink)) {}

std::string Course::phase_name() const {
  const Phase* phase = protocol_.phase();
  return phase != nullptr ? std::string(quicksand::phase_name(*phase)) : std::string("end");
}

Progress Course::advance() {
  if (row_.phase.empty()) sample();
  const ProtocolState before = protocol_.state();
  const std::int64_t step_before = world().step;
  const double time_before = world().time;
  if (protocol_.phase() != nullptr && (before.phase != times_of_ || !before.entered)) {
    times_ =
        SampleTimes(before.entered ? before.phase_start : time_before,
                    sample_interval(protocol_.scenario(), *protocol_.phase(), every_), time_before);
    times_of_ = before.phase;
  }
  phase_ = phase_name();
  const Progress progress = protocol_.advance();
  if (world().step != step_before) count(before);
  if (times_.due(world().time) || progress == Progress::phase_ended) sample();
  return progress;
}

void Course::sample_every(std::optional<double> every) {
  every_ = every;
  times_of_ = -1;
}

void Course::count(const ProtocolState& before) {
  const ProtocolState& now = protocol_.state();
  const SolveReport& solve = protocol_.last_step().solve;
  pending_.residual = std::max(pending_.residual, solve.residual.natural);
  pending_.gap_error = std::max(pending_.gap_error, solve.residual.gap);
  pending_.velocity_change = std::max(pending_.velocity_change, solve.velocity_change);
  pending_.iterations += now.iterations - before.iterations;
  pending_.factorisations += now.factorisations - before.factorisations;
  pending_.trial = now.search.trial;
  pending_.trial_force = now.search.force;
  pending_.unconverged += now.unconverged_steps - before.unconverged_steps;
}

void Course::sample() {
  const World& world = protocol_.world();
  const bool first = row_.phase.empty();
  if (!first && row_.sample.step == world.step && bodies_ == world.disks.size() &&
      healed_ == world.bonds.healed)
    return;
  if (first) phase_ = phase_name();
  row_ = std::exchange(pending_, {});
  row_.sample = measure(world);
  row_.phase = phase_;
  bodies_ = world.disks.size();
  healed_ = world.bonds.healed;
  sink_(row_, world);
}

}  // namespace quicksand
