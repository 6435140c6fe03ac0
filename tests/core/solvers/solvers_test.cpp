#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/problem/residual.h"
#include "core/problem/solver_settings.h"
#include "core/solvers/contact_solver.h"
#include "tests/support/core/agreement.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Solver);

// Of 200 problems with rolling or strong friction. Gauss-Seidel may run in circles there and an interior
// point get stuck, which they must say; the fallback chain may not.
int may_give_up(Method method) { return method == Method::automatic ? 0 : 3; }

TEST_P(Solver, AgreesWithTheReferenceWithoutFriction) {
  const Agreement a = compare(GetParam(), {.bodies = 5, .contacts = 6, .components = 1}, 200, 1);
  EXPECT_EQ(a.unconverged, 0);
  EXPECT_GE(a.compared, 80);
  EXPECT_EQ(a.modes.size(), 2U);
}

TEST_P(Solver, AgreesWithTheReferenceWithFriction) {
  const Agreement a = compare(GetParam(), {.bodies = 4, .contacts = 4, .components = 2}, 200, 2);
  EXPECT_EQ(a.unconverged, 0);
  EXPECT_GE(a.compared, 80);
  EXPECT_EQ(a.modes.size(), 4U) << "some mode was never met";
}

TEST_P(Solver, AgreesWithTheReferenceWithRollingFriction) {
  const Agreement a = compare(GetParam(), {.bodies = 4, .contacts = 3, .components = 3}, 200, 3);
  EXPECT_LE(a.unconverged, may_give_up(GetParam()));
  EXPECT_GE(a.compared, 80);
  EXPECT_EQ(a.modes.size(), 10U) << "some mode was never met";
}

TEST_P(Solver, AgreesWithTheReferenceForFrictionCoefficientsUpToThree) {
  const Agreement a = compare(
      GetParam(), {.bodies = 4, .contacts = 3, .components = 3, .largest_friction = 3}, 200, 4);
  EXPECT_LE(a.unconverged, may_give_up(GetParam()));
}

TEST_P(Solver, AgreesWithTheReferenceForMassRatiosUpToTenThousand) {
  const Agreement a =
      compare(GetParam(), {.bodies = 4, .contacts = 3, .components = 3, .mass_ratio = 1e4}, 200, 5);
  EXPECT_LE(a.unconverged, may_give_up(GetParam()));
}

TEST_P(Solver, AgreesWithTheReferenceWhereNothingIsFixed) {
  const Agreement a = compare(
      GetParam(), {.bodies = 4, .contacts = 3, .components = 3, .fixed_body = false}, 100, 6);
  EXPECT_LE(a.unconverged, may_give_up(GetParam()));
}

TEST_P(Solver, AgreesWithTheReferenceForBodiesOfAnyShape) {
  const Agreement a =
      compare(GetParam(), {.bodies = 4, .contacts = 3, .components = 3, .disks = false}, 200, 9);
  EXPECT_LE(a.unconverged, may_give_up(GetParam()));
  EXPECT_GE(a.compared, 80);
}

TEST_P(Solver, SlowAgreesWithTheReferenceForFourRollingContacts) {
  const Agreement a = compare(GetParam(), {.bodies = 4, .contacts = 4, .components = 3}, 40, 7);
  EXPECT_LE(a.unconverged, may_give_up(GetParam()));
}

TEST_P(Solver, DoesNotReadWhatIsNotModelled) {
  Random random{8};
  for (int components : {1, 2}) {
    const ContactProblem clean =
        random_problem({.bodies = 5, .contacts = 6, .components = components}, random);
    ContactProblem poisoned = clean;
    poison_unused_coefficients(poisoned);
    // The matrix of the interior point is the same for all laws: it multiplies arms by zero impulses.
    if (GetParam() == Method::gauss_seidel) poison_unused_arms(poisoned);
    ContactState expected = zero_state(clean), state = zero_state(clean);
    EXPECT_TRUE(solve(clean, tight(GetParam()), expected).converged);
    EXPECT_TRUE(solve(poisoned, tight(GetParam()), state).converged);
    for (std::size_t i = 0; i < state.velocity.size(); ++i)
      EXPECT_EQ(distance(state.velocity[i], expected.velocity[i]), 0) << components;
  }
}

// The same contact listed twice: the impulses are not unique, the velocities are.
TEST_P(Solver, ARedundantContactDoesNotChangeTheVelocities) {
  Random random{9};
  for (int k = 0; k < 50; ++k) {
    const ContactProblem simple =
        random_problem({.bodies = 4, .contacts = 3, .components = 3}, random);
    const auto reference = reference_solutions(simple);
    if (!reference.complete || reference.solutions.size() != 1) continue;
    ContactProblem doubled = simple;
    for (const ContactRow& row : simple.contacts) doubled.contacts.push_back(row);
    ContactState state = zero_state(doubled);
    EXPECT_TRUE(solve(doubled, tight(GetParam()), state).converged);
    EXPECT_LE(distance_to_nearest(reference.solutions, state.velocity), tolerance::solved());
  }
}

TEST_P(Solver, AWarmStartGivesTheSameVelocities) {
  Random random{10};
  for (int k = 0; k < 50; ++k) {
    const ContactProblem problem =
        random_problem({.bodies = 4, .contacts = 3, .components = 3}, random);
    const auto reference = reference_solutions(problem);
    if (!reference.complete || reference.solutions.size() != 1) continue;
    ContactState state = zero_state(problem);
    // Wrong on purpose, even outside the cones.
    for (Vec3& p : state.impulse)
      p = Vec3{random.uniform(), random.uniform() - 0.5, random.uniform() - 0.5};
    EXPECT_TRUE(solve(problem, tight(GetParam()), state).converged);
    EXPECT_LE(distance_to_nearest(reference.solutions, state.velocity), tolerance::solved());
  }
}

TEST_P(Solver, StartsFromASolutionWithoutIterating) {
  const ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  ContactState state{.velocity = problem.free_velocity, .impulse = {Vec3(2, 0, 0)}};
  const SolveReport report = solve(problem, tight(GetParam()), state);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(distance(state.velocity[0], Vec3(0, 0, 0)), 0);
}

TEST_P(Solver, ReportsTheResidualOfTheStateItReturns) {
  Random random{11};
  const ContactProblem problem = random_problem({.bodies = 5, .contacts = 8}, random);
  for (int iterations : {0, 1, 3, 100}) {
    ContactState state = zero_state(problem);
    SolverSettings settings = tight(GetParam());
    settings.max_iterations = iterations;
    const SolveReport report = solve(problem, settings, state);
    EXPECT_EQ(report.residual.natural, residual(problem, state).natural);
    EXPECT_LE(report.iterations, iterations);
  }
}

TEST_P(Solver, NeverCallsAProblemWithANotANumberConverged) {
  ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  problem.free_velocity[0].y() = std::numeric_limits<double>::quiet_NaN();
  ContactState state = zero_state(problem);
  SolverSettings settings = tight(GetParam());
  settings.max_iterations = 100;
  EXPECT_FALSE(solve(problem, settings, state).converged);
}

TEST_P(Solver, SolvesAfterAProblemThatItCouldNotSolveAsIfItWereTheFirst) {
  ContactProblem hopeless = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  hopeless.free_velocity[0].y() = std::numeric_limits<double>::quiet_NaN();
  const SolverSettings settings = tight(GetParam());
  ContactSolver used;
  ContactState lost = zero_state(hopeless);
  EXPECT_FALSE(used.solve(hopeless, settings, lost).converged);

  Random random{15};
  const ContactProblem problem = random_problem({.bodies = 5, .contacts = 5}, random);
  ContactState first = zero_state(problem), after = first;
  const SolveReport as_the_first = solve(problem, settings, first);
  EXPECT_TRUE(as_the_first.converged);
  const SolveReport report = used.solve(problem, settings, after);
  EXPECT_EQ(report.factorisations, as_the_first.factorisations);
  EXPECT_EQ(report.iterations, as_the_first.iterations);
  EXPECT_EQ(after.impulse, first.impulse);
}

TEST_P(Solver, AnOverlapIsPushedApartWithinTheStep) {
  ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  problem.contacts[0].offset.x() = -0.5;
  ContactState state = zero_state(problem);
  EXPECT_TRUE(solve(problem, tight(GetParam()), state).converged);
  EXPECT_NEAR(state.velocity[0].y(), 0.5, tolerance::solved());
}

TEST_P(Solver, AnEmptyProblemIsSolved) {
  ContactState state;
  EXPECT_TRUE(solve({.dt = 0.1}, tight(GetParam()), state).converged);
}

// A closed packing of many loops: a triangular crystal on a floor that two walls hold together.
TEST_P(Solver, ACrystalPatchAtRestStaysAtRest) {
  ContactProblem problem;
  problem.dt = 0.01;
  problem.inverse_mass = {Vec3(0, 0, 0)};
  problem.free_velocity = {Vec3(0, 0, 0)};
  std::vector<Vec2> place{Vec2(0, 0)};
  constexpr int kRows = 5, kColumns = 5;
  const double rise = std::sqrt(0.75);
  const auto touch = [&](int a, int b, const Vec2& normal, double arm_a) {
    problem.contacts.push_back({.a = a,
                                .b = b,
                                .normal = normal,
                                .spin_a = {0, arm_a},
                                .spin_b = {0, -0.5},
                                .arm = 0.5,
                                .friction = 0.3,
                                .rolling = 0.05,
                                .gap_tolerance = 1e-3});
  };
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      const Vec2 p(x + 0.5 * (y % 2), rise * y);
      const auto i = static_cast<int>(place.size());
      problem.inverse_mass.emplace_back(1, 1, 8);
      problem.free_velocity.emplace_back(0, -problem.dt, 0);
      if (y == 0) touch(0, i, {0, 1}, 0);
      if (x == 0) touch(0, i, {1, 0}, 0);
      if (x == kColumns - 1) touch(0, i, {-1, 0}, 0);
      for (int j = 1; j < i; ++j) {
        const Vec2 apart = p - place[static_cast<std::size_t>(j)];
        if (apart.norm() < 1 + 1e-9) touch(j, i, apart, 0.5);
      }
      place.push_back(p);
    }
  }
  ContactState state = zero_state(problem);
  EXPECT_TRUE(solve(problem, tight(GetParam()), state).converged);
  for (const Vec3& v : state.velocity) EXPECT_LE(v.norm(), tolerance::solved(problem.dt));
  Vec2 on_floor(0, 0);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c)
    if (problem.contacts[c].a == 0)
      on_floor += momentum_of_b(problem.contacts[c], state.impulse[c]).head<2>();
  EXPECT_NEAR(on_floor.y() / problem.dt, kRows * kColumns, tolerance::solved(25));
}

}  // namespace
}  // namespace quicksand
