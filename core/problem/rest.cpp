#include "core/problem/rest.h"

#include <algorithm>

namespace quicksand {

bool at_rest(const ContactProblem& problem, const SolverSettings& settings,
             const std::vector<Vec3>& velocity) {
  constexpr double kArm = 0.5;         // of a grain: what turns moves as fast at its rim [d]
  constexpr double kRounding = 1e-13;  // some hundred roundings of an impulse
  const double share = std::max(SolverSettings::kAsItIs * settings.tolerance, kRounding);
  const double momentum = share * problem.force_scale * problem.dt;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const Vec3 most = momentum * Vec3(1, 1, kArm).cwiseProduct(problem.inverse_mass[i]);
    if ((velocity[i].array().abs() > most.array()).any()) return false;
  }
  return true;
}

}  // namespace quicksand
