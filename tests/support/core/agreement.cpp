#include "tests/support/core/agreement.h"

#include <gtest/gtest.h>

#include "core/solvers/contact_solver.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {

SolverSettings tight(Method method) {
  return {.method = method, .tolerance = tolerance::kTight, .max_iterations = 2000000};
}

Agreement compare(const SolverSettings& settings, int problems,
                  const std::function<ContactProblem()>& next, double accuracy) {
  Agreement agreement;
  for (int k = 0; k < problems; ++k) {
    const ContactProblem problem = next();
    ContactState state = zero_state(problem);
    if (!solve(problem, settings, state).converged) {
      ++agreement.unconverged;
      continue;
    }
    EXPECT_LE(law_violation(problem, state.impulse), accuracy) << "problem " << k;
    const auto [solutions, complete] = reference_solutions(problem);
    if (solutions.empty()) continue;
    const double off = distance_to_nearest(solutions, state.velocity);
    if (off <= accuracy) ++agreement.agreeing;
    // Without friction the velocities are unique even where redundant contacts leave impulses open.
    if (!complete && problem.components > 1) continue;
    EXPECT_LE(off, accuracy) << "problem " << k << ", " << solutions.size() << " solutions";
    ++agreement.compared;
    for (const Mode& mode : solutions.front().modes) agreement.modes.insert(mode);
  }
  return agreement;
}

Agreement compare(Method method, const ProblemShape& shape, int problems, std::uint64_t seed) {
  Random random{seed};
  return compare(
      tight(method), problems, [&] { return random_problem(shape, random); }, tolerance::solved());
}

}  // namespace quicksand
