#include "core/step/resting_step.h"

namespace quicksand {

bool RestingStep::known(const World& world, const StepSettings& step,
                        const SolverSettings& solver) const {
  return world_ && step == step_ && solver == solver_ && same_but_for_time(world, *world_);
}

const StepReport* RestingStep::repeated(const World& world, const StepSettings& step,
                                        const SolverSettings& solver) const {
  return report_ && known(world, step, solver) ? &*report_ : nullptr;
}

void RestingStep::ended(const World& world, const StepSettings& step, const SolverSettings& solver,
                        const StepReport& report) {
  // It began where the step before it ended.
  const bool repeats = known(world, step, solver) && world.step == world_->step + 1;
  report_ = repeats ? std::optional(report) : std::nullopt;
  world_ = world;
  step_ = step;
  solver_ = solver;
}

}  // namespace quicksand
