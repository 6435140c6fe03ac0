// Rest: while nothing changes, a step is computed once. One that begins as the last one began and ended, at rest, ends
// so, too, until somebody acts on the world.
#pragma once

#include <optional>

#include "core/step/step.h"

namespace quicksand {

class RestingStep {
 public:
  // What the next step would report if it were computed, where it is known that it changes nothing but the time.
  const StepReport* repeated(const World& world, const StepSettings& step,
                             const SolverSettings& solver) const;
  // A step has ended at rest, in this world.
  void ended(const World& world, const StepSettings& step, const SolverSettings& solver,
             const StepReport& report);

 private:
  bool known(const World& world, const StepSettings& step, const SolverSettings& solver) const;

  std::optional<World> world_;  // after the last step that ended at rest
  StepSettings step_;
  SolverSettings solver_;
  std::optional<StepReport> report_;  // of a step that also began so
};

}  // namespace quicksand
