#include "core/step/step_settings.h"

namespace quicksand {

StepSettings nscd_step() {
  return {.nscd = Nscd{},
          .dt = 1e-3,
          .break_rule = FailureCriterion::geometric,
          .curvature_term = false,
          .stop_if_unconverged = false};
}

}  // namespace quicksand
