#include "core/interior_point/newton_on_modes.h"

#include <gtest/gtest.h>

#include "core/problem/residual.h"
#include "core/problem/solver_settings.h"
#include "core/solvers/contact_solver.h"
#include "tests/support/core/random_problems.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

constexpr int kIterations = 20;

SolveReport finish(const ContactProblem& problem, ContactState& state) {
  ContactMatrix matrix;
  matrix.attach(problem);
  return NewtonOnModes().solve(problem, {}, kIterations, matrix, state);
}

// The grain of disk_on_floor falls at 2, with friction 0.3 and rolling friction 0.05.
TEST(NewtonOnModes, GetsTheImpulsesOfASlidingDiskFromARoughGuess) {
  const ContactProblem problem = disk_on_floor({5, -2, 0}, 0.3, 10);
  ContactState state{.velocity = {}, .impulse = {{1.5, 0.4, -0.2}}};
  const SolveReport report = finish(problem, state);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR((state.impulse[0] - Vec3(2, 0.6, -0.3)).norm(), 0, tolerance::rounding());
  EXPECT_NEAR(report.velocity_change.value(), 0, tolerance::rounding());
}

TEST(NewtonOnModes, LetsGoOfADiskThatFliesOff) {
  const ContactProblem problem = disk_on_floor({1, 2, 3}, 0.3, 0.05);
  ContactState state{.velocity = {}, .impulse = {{0.1, 0, 0}}};
  EXPECT_TRUE(finish(problem, state).converged);
  EXPECT_EQ(state.impulse[0], Vec3(0, 0, 0));
}

// As the solutions of the interior point are: near, with every mode right.
TEST(NewtonOnModes, EndsSolutionsOfRandomProblemsAtRounding) {
  Random random{11};
  int ended = 0;
  constexpr int kProblems = 200;
  for (int k = 0; k < kProblems; ++k) {
    const ContactProblem problem =
        random_problem({.bodies = 5, .contacts = 5, .components = 3}, random);
    ContactState state = zero_state(problem);
    if (!solve(problem, {.tolerance = 1e-5}, state).converged) continue;
    for (Vec3& p : state.impulse) p *= 1 + 1e-6;
    const double before = residual(problem, state).natural;
    const SolveReport report = finish(problem, state);
    EXPECT_LE(report.residual.natural, before);
    EXPECT_EQ(report.residual.natural, residual(problem, state).natural)
        << "of what is left behind";
    ended += report.residual.natural < 1e-12;
  }
  EXPECT_GE(ended, kProblems * 95 / 100);
}

// Starting with wrong modes it may fail, but never leaves anything worse.
TEST(NewtonOnModes, NeverLeavesWhatIsWorseThanTheStart) {
  Random random{12};
  for (int k = 0; k < 200; ++k) {
    const ContactProblem problem =
        random_problem({.bodies = 5, .contacts = 6, .components = 3}, random);
    ContactState state = zero_state(problem);
    const double before = residual(problem, state).natural;
    const SolveReport report = finish(problem, state);
    EXPECT_LE(report.residual.natural, before);
    EXPECT_EQ(report.converged, SolverSettings{}.accepts(report.residual));
  }
}

}  // namespace
}  // namespace quicksand
