// All solvers on the hardest small problems, against the reference that tries every mode: masses from 1
// to a million, friction from 0 to 3, redundant contacts, walls that move and walls that do not.
#include <gtest/gtest.h>

#include "core/problem/solver_settings.h"
#include "core/solvers/contact_solver.h"
#include "tests/support/core/agreement.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/random_heaps.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(SlowExtremeProblem);

constexpr double kMassRatios[] = {1, 1e2, 1e4, 1e6};

SolverSettings patient(Method method) {
  SolverSettings settings = tight(method);
  settings.max_iterations = 200000;
  return settings;
}

// Not converging to 1e-11 is an answer, and a rare one: at large mass ratios Gauss-Seidel crawls, and an
// interior point runs out of digits.
int may_give_up(Method method, int problems, double mass_ratio) {
  switch (method) {
    case Method::automatic:
      return mass_ratio <= 1e2 ? 0 : problems / 20;
    case Method::interior_point:
      return problems / 10;
    default:
      return problems / 5;
  }
}

// Forces are judged relative to the mean momentum, so that a light grain among heavy ones has the more
// error in its velocity.
double accuracy(double mass_ratio) { return tolerance::solved(mass_ratio > 1e5 ? 10 : 1); }

void compare_random_problems(Method method, ProblemShape shape, int problems,
                             std::size_t number_of_modes) {
  for (double mass_ratio : kMassRatios) {
    SCOPED_TRACE(mass_ratio);
    Random random{1};
    shape.mass_ratio = mass_ratio;
    const auto next = [&] {
      ContactProblem problem = random_problem(shape, random);
      problem.force_scale *= std::max(1.0, std::sqrt(mass_ratio) / 10);
      return problem;
    };
    const Agreement a = compare(patient(method), problems, next, accuracy(mass_ratio));
    EXPECT_LE(a.unconverged, may_give_up(method, problems, mass_ratio));
    EXPECT_GE(a.compared, problems / 3);
    EXPECT_EQ(a.modes.size(), number_of_modes) << "some mode was never met";
  }
}

TEST_P(SlowExtremeProblem, OfVolumeExclusionHasTheVelocitiesOfTheReference) {
  compare_random_problems(GetParam(), {.bodies = 5, .contacts = 7, .components = 1}, 100, 2);
}

TEST_P(SlowExtremeProblem, OfFrictionUpToThreeHasTheVelocitiesOfTheReference) {
  compare_random_problems(
      GetParam(), {.bodies = 4, .contacts = 4, .components = 2, .largest_friction = 3}, 60, 4);
}

TEST_P(SlowExtremeProblem, OfRollingFrictionHasTheVelocitiesOfTheReference) {
  compare_random_problems(
      GetParam(), {.bodies = 4, .contacts = 3, .components = 3, .largest_friction = 3}, 250, 10);
}

// Geometry that fits into the plane: disks on each other, on walls and under a piston.
void compare_heaps(Method method, HeapShape shape, std::size_t most_contacts, int problems) {
  for (double mass_ratio : kMassRatios) {
    for (double bonded : {0.0, 0.5}) {
      SCOPED_TRACE(testing::Message() << mass_ratio << ", bonded " << bonded);
      Random random{2};
      shape.mass_ratio = mass_ratio;
      shape.bonded = bonded;
      const auto next = [&] {
        for (;;) {
          ContactProblem problem = next_problem(random_heap(shape, random));
          if (problem.contacts.size() <= most_contacts) return problem;
        }
      };
      const Agreement a = compare(patient(method), problems, next, accuracy(mass_ratio));
      EXPECT_LE(a.unconverged, may_give_up(method, problems, mass_ratio));
      // Rolling friction of a wedged disk depends on how hard it is wedged, which the laws leave open.
      if (shape.components < 3) {
        EXPECT_GE(a.compared, problems / 2);
      }
      EXPECT_GE(a.agreeing, problems * 3 / 4);
    }
  }
}

// More contacts than degrees of freedom: only some of the forces are determined, all velocities are.
TEST_P(SlowExtremeProblem, OfAHeapWithoutFrictionHasTheVelocitiesOfTheReference) {
  compare_heaps(GetParam(), {.disks = 4, .components = 1}, 12, 30);
}

TEST_P(SlowExtremeProblem, OfAHeapWithFrictionHasTheVelocitiesOfTheReference) {
  compare_heaps(GetParam(), {.disks = 3, .components = 2, .largest_friction = 3}, 5, 30);
}

TEST_P(SlowExtremeProblem, OfAHeapWithRollingFrictionHasTheVelocitiesOfTheReference) {
  compare_heaps(GetParam(), {.disks = 2, .components = 3, .largest_friction = 3}, 3, 40);
}

// Some contacts twice, some three times.
TEST_P(SlowExtremeProblem, RepeatedContactsDoNotChangeTheVelocities) {
  Random random{3};
  int compared = 0, unconverged = 0;
  for (int k = 0; k < 60; ++k) {
    const ContactProblem simple = random_problem(
        {.bodies = 4, .contacts = 3, .components = 3, .largest_friction = 3, .mass_ratio = 1e3},
        random);
    const Reference reference = reference_solutions(simple);
    if (!reference.complete || reference.solutions.size() != 1) continue;
    ContactProblem repeated = simple;
    repeated.force_scale *= 10;
    for (const ContactRow& row : simple.contacts)
      for (double u = random.uniform(); u > 0.3; u -= 0.35) repeated.contacts.push_back(row);
    ContactState state = zero_state(repeated);
    if (!solve(repeated, patient(GetParam()), state).converged) {
      ++unconverged;
      continue;
    }
    ++compared;
    EXPECT_LE(distance_to_nearest(reference.solutions, state.velocity), tolerance::solved());
  }
  EXPECT_GE(compared, 15);
  EXPECT_LE(unconverged, GetParam() == Method::automatic ? 0 : 3);
}

}  // namespace
}  // namespace quicksand
