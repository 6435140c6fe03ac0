#include "app/run/recorder.h"

#include <algorithm>
#include <utility>

namespace quicksand {

void Recorder::count(const ProtocolState& before, const Protocol& after) {
  const ProtocolState& now = after.state();
  pending_.residual = std::max(pending_.residual, after.last_step().solve.residual.natural);
  pending_.gap_error = std::max(pending_.gap_error, after.last_step().solve.residual.gap);
  pending_.velocity_change =
      std::max(pending_.velocity_change, after.last_step().solve.velocity_change);
  pending_.iterations += now.iterations - before.iterations;
  pending_.factorisations += now.factorisations - before.factorisations;
  pending_.trial = now.search.trial;
  pending_.trial_force = now.search.force;
  pending_.unconverged += now.unconverged_steps - before.unconverged_steps;
}

void Recorder::sample(const World& world, const std::string& phase) {
  const bool first = row_.phase.empty();
  if (!first && row_.sample.step == world.step && bodies_ == world.disks.size() &&
      healed_ == world.bonds.healed)
    return;
  row_ = std::exchange(pending_, {});
  row_.sample = measure(world);
  row_.phase = phase;
  bodies_ = world.disks.size();
  healed_ = world.bonds.healed;
  // The earlier part of a continued run ended with this sample.
  if (first && series_.last_step() == world.step) return;
  series_.add(row_);
  if (film_ != nullptr) film_->add(world, phase);
}

}  // namespace quicksand
