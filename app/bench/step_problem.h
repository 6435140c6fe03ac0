// The contact problem of a world's next step, as the step itself poses it first.
#pragma once

#include <optional>

#include "core/problem/contact_problem.h"
#include "core/scene/scenario.h"
#include "core/world/world.h"

namespace quicksand::bench {

struct StepProblem {
  ContactProblem problem;
  std::vector<Vec3> start;     // (nc) warm start: impulses of the last step
  std::vector<Vec3> no_force;  // (nc) N = F_c dt where bonded: no contact gives any force
};

// The step is shortened as its max_turn demands.
StepProblem next_problem(const World& world, const StepSettings& settings);

// Bodies that turn freely: disks that are not fixed.
std::int64_t mobile_disks(const ContactProblem& problem);

// The step settings of a scene in one of its phases.
StepSettings step_in_phase(const Scenario& scenario, int phase);

// A phase in which nothing is added and which no rest ends.
inline Phase watching(double max_time, std::optional<double> dt = {}) {
  return {.kind = SettlePhase{.max_time = max_time, .until_rest = false}, .dt = dt};
}

}  // namespace quicksand::bench
