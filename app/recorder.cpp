#include "app/recorder.h"

#include <algorithm>
#include <utility>

namespace quicksand {

void Recorder::count(const StepReport& step) {
  pending_.residual = std::max(pending_.residual, step.solve.residual.natural);
  pending_.iterations += step.solve.iterations;
  pending_.factorisations += step.solve.factorisations;
  pending_.unconverged += step.converged ? 0 : 1;
}

void Recorder::sample(const World& world, const std::string& phase) {
  const bool first = row_.phase.empty();
  if (!first && row_.sample.step == world.step && bodies_ == world.disks.size()) return;
  row_ = std::exchange(pending_, {});
  row_.sample = measure(world);
  row_.phase = phase;
  bodies_ = world.disks.size();
  // The earlier part of a continued run ended with this sample.
  if (first && series_.last_step() == world.step) return;
  series_.add(row_);
  if (film_ != nullptr) film_->add(world, phase);
}

}  // namespace quicksand
