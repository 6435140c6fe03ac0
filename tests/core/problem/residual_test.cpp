#include "core/problem/residual.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/core/random_problems.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN(),
                 kInfinity = std::numeric_limits<double>::infinity();

// The grain of disk_on_floor has mass 1 and inertia 1/8, dt = 0.1, force scale 1.
Residual residual_of(const ContactProblem& problem, const Vec3& impulse) {
  ContactState state{.velocity = problem.free_velocity, .impulse = {impulse}};
  return residual(problem, state);
}

double natural(const ContactProblem& problem, const Vec3& impulse) {
  return residual_of(problem, impulse).natural;
}

TEST(Residual, IsZeroForADiskThatIsCaughtByTheFloor) {
  const ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  EXPECT_EQ(natural(problem, {2, 0, 0}), 0);
}

TEST(Residual, IsZeroForADiskThatFliesOff) {
  const ContactProblem problem = disk_on_floor({1, 2, 3}, 0.3, 0.05);
  EXPECT_EQ(natural(problem, {0, 0, 0}), 0);
}

// Sliding at the Coulomb bound; too much rolling friction to turn: T balances the torque of R_t.
TEST(Residual, IsZeroForADiskThatSlides) {
  const ContactProblem problem = disk_on_floor({5, -2, 0}, 0.3, 10);
  EXPECT_NEAR(natural(problem, {2, 0.6, -0.3}), 0, tolerance::rounding());
}

TEST(Residual, IsZeroForADiskThatSpinsDownByRollingFriction) {
  const ContactProblem problem = disk_on_floor({0, -2, 4}, 0, 0.05);
  EXPECT_NEAR(natural(problem, {2, 0, 0.1}), 0, tolerance::rounding());
}

TEST(Residual, WithoutContactsThereIsNothingToViolate) {
  ContactProblem problem = disk_on_floor({1, 2, 3}, 0, 0);
  problem.contacts.clear();
  ContactState state = zero_state(problem);
  const Residual r = residual(problem, state);
  EXPECT_EQ(r.natural, 0);
  EXPECT_EQ(r.gap, 0);
}

// Each law violated alone, by a known amount; forces are impulses over dt = 0.1.
TEST(Residual, MeasuresAMissingNormalImpulse) {
  const ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  EXPECT_NEAR(natural(problem, {1.9, 0, 0}), 0.1 / 0.1, tolerance::rounding());
}

TEST(Residual, MeasuresAnAttractionThatNoBondExplains) {
  const ContactProblem problem = disk_on_floor({0, 2, 0}, 0.3, 0.05);
  EXPECT_NEAR(natural(problem, {-0.25, 0, 0}), 0.25 / 0.1, tolerance::rounding());
}

TEST(Residual, MeasuresAnImpulseOnAnOpenContact) {
  const ContactProblem problem = disk_on_floor({0, 2, 0}, 0.3, 0.05);
  EXPECT_NEAR(natural(problem, {0.25, 0, 0}), 0.25 / 0.1, tolerance::rounding());
}

TEST(Residual, MeasuresAGapThatIsNotYetClosed) {
  ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  problem.contacts[0].offset.x() = 0.5;
  EXPECT_NEAR(natural(problem, {1.5, 0, 0}), 0, tolerance::rounding());
  EXPECT_NEAR(natural(problem, {2, 0, 0}), 0.5 / 0.1, tolerance::rounding());
}

TEST(Residual, MeasuresAForceOutsideTheFrictionCone) {
  const ContactProblem problem = disk_on_floor({5, -2, 0}, 0.3, 10);
  EXPECT_NEAR(natural(problem, {2, 0.7, -0.35}), 0.1 / 0.1, tolerance::rounding());
}

TEST(Residual, MeasuresSlipWithoutFullFriction) {
  const ContactProblem problem = disk_on_floor({5, -2, 0}, 0.3, 10);
  EXPECT_NEAR(natural(problem, {2, 0.5, -0.25}), 0.1 / 0.1, tolerance::rounding());
}

TEST(Residual, MeasuresARollingTorqueThatIsTooLarge) {
  const ContactProblem problem = disk_on_floor({0, -2, 4}, 0, 0.05);
  EXPECT_NEAR(natural(problem, {2, 0, 0.2}), 0.1 / 0.5 / 0.1, tolerance::rounding());
}

TEST(Residual, MeasuresTheGapErrorOfContactsThatAreLoadedOrOverlap) {
  const ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  // Opening velocity 0.01 over dt 0.1 is a gap of 1e-3, the tolerance.
  EXPECT_NEAR(residual_of(problem, {2.01, 0, 0}).gap, 1, tolerance::rounding(1e3));
  EXPECT_NEAR(residual_of(problem, {0, 0, 0}).gap, 2 * 0.1 / 1e-3, tolerance::rounding(1e3))
      << "nothing stops it";
  EXPECT_EQ(residual_of(disk_on_floor({0, 2, 0}, 0.3, 0.05), {0, 0, 0}).gap, 0) << "it flies off";
}

// Of interest only up to a bound: beyond it some contact that violates it will do, below it the worst counts.
TEST(Residual, IsTheWorstUpToABoundAndBeyondIt) {
  Random random{1};
  const ContactProblem problem = random_problem({.bodies = 300, .contacts = 600}, random);
  ContactState state = zero_state(problem);
  const double worst = residual(problem, state).natural;
  ASSERT_GT(worst, 0);
  EXPECT_EQ(residual(problem, state, {.natural = worst, .gap = kInfinity}).natural, worst);
  const double beyond =
      residual(problem, state, {.natural = worst / 100, .gap = kInfinity}).natural;
  EXPECT_GT(beyond, worst / 100);
  EXPECT_LT(beyond, worst) << "it looked at all contacts";
}

TEST(Residual, DoesNotTrustTheVelocityThatASolverReports) {
  const ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  ContactState state{.velocity = {Vec3(9, kNotANumber, 9), Vec3(9, 9, 9)},
                     .impulse = {Vec3(2, 0, 0)}};
  EXPECT_EQ(residual(problem, state).natural, 0);
  EXPECT_EQ(distance(state.velocity[0], Vec3(0, 0, 0)), 0) << "it leaves the true one";
}

// A number that is not finite must never pass as a small residual, wherever it stands.
TEST(Residual, IsInfiniteWhereAnyImpulseIsNotANumber) {
  for (int k = 0; k < 3; ++k) {
    for (double bad : {kNotANumber, std::numeric_limits<double>::infinity()}) {
      const ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
      Vec3 impulse(2, 0, 0);
      impulse[k] = bad;
      EXPECT_TRUE(std::isinf(natural(problem, impulse))) << "component " << k << " is " << bad;
    }
  }
}

TEST(Residual, IsInfiniteWhereAnyFreeVelocityIsNotANumber) {
  for (int k = 0; k < 3; ++k) {
    ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
    problem.free_velocity[0][k] = kNotANumber;
    EXPECT_TRUE(std::isinf(natural(problem, {2, 0, 0}))) << "component " << k;
  }
}

TEST(Residual, DoesNotReadWhatIsNotModelled) {
  for (int components : {1, 2}) {
    ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
    problem.components = components;
    poison_unused_coefficients(problem);
    poison_unused_arms(problem);
    EXPECT_EQ(natural(problem, {2, 0, 0}), 0) << components << " components";
  }
}

TEST(Residual, ABodyThatCannotMoveIsJudgedWithoutDividingByZero) {
  ContactProblem problem = disk_on_floor({0, -2, 0}, 0.3, 0.05);
  problem.inverse_mass[0] = {0, 0, 0};
  EXPECT_TRUE(std::isfinite(natural(problem, {0, 0, 0})));
}

}  // namespace
}  // namespace quicksand
