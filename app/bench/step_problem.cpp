#include "app/bench/step_problem.h"

#include <algorithm>
#include <cmath>

#include "core/scene/scenario.h"
#include "core/step/assemble.h"
#include "core/world/neighbors.h"

namespace quicksand::bench {

StepProblem next_problem(const World& world, const StepSettings& settings) {
  StepProblem result;
  StepSettings step = settings;
  step.dt = std::ldexp(step.dt, -halvings_by_turning(world, step));
  std::vector<Vec3> free;
  free_velocities(world, step.dt, free);
  const double reach = contact_reach(world, free, step.dt);
  std::vector<Contact> contacts;
  find_contacts(world, pairs_within(world, reach), free, step.dt, contacts);
  build_problem(world, contacts, free, step, result.problem);
  for (const Contact& contact : contacts) {
    result.start.push_back(contact.impulse);
    result.no_force.emplace_back(contact.cohesion * step.dt, 0, 0);
  }
  return result;
}

std::int64_t mobile_disks(const ContactProblem& problem) {
  return std::ranges::count_if(problem.inverse_mass, [](const Vec3& m) { return m.z() > 0; });
}

StepSettings step_in_phase(const Scenario& scenario, int phase) {
  StepSettings step = scenario.step;
  step.dt = scenario.phases.at(static_cast<std::size_t>(phase)).dt.value_or(step.dt);
  return step;
}

}  // namespace quicksand::bench
