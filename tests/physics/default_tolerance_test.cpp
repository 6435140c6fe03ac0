// What a user gets who leaves the solver's tolerance as it is.
#include <gtest/gtest.h>

#include "core/problem/solver_settings.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"

namespace quicksand {
namespace {

// A residual is local, and what it leaves adds up: along a chain to n^2 times the tolerance in the first
// bond, and in a heavy body to the mass ratio times it. Solutions therefore do not end at the tolerance,
// but with the linear equations of what sticks, slides and rolls.
Simulation with_default_tolerance(Scenario scene) {
  scene.solver.tolerance = SolverSettings{}.tolerance;
  return Simulation(scene);
}

void expect_holds_at(double share, Method method, int n) {
  Simulation run = with_default_tolerance(hanging_chain(method, n, n / share));
  run.advance(100);
  EXPECT_EQ(run.unconverged, 0);
  EXPECT_EQ(run.bonds_broken, 0);
}

TEST(DefaultTolerance, AChainOfAThousandHoldsCloseToItsLimit) {
  expect_holds_at(0.99, Method::automatic, 1000);
}
TEST(DefaultTolerance, AChainOfAThousandHoldsByTheInteriorPointAlone) {
  expect_holds_at(0.9, Method::interior_point, 1000);
}
TEST(DefaultTolerance, AChainOfTenThousandHoldsCloseToItsLimit) {
  expect_holds_at(0.99, Method::automatic, 10000);
}

// With n^2/2 above mu_r F_c/(m g d) = 500 it turns about the first contact as a rigid rod.
TEST(DefaultTolerance, ACantileverBeyondItsLimitYieldsAtTheRateOfARigidRod) {
  constexpr int kLength = 32;
  constexpr double kMoment = 500, kTime = 0.1;
  Simulation run = with_default_tolerance(cantilever(Method::automatic, kLength, 1e4));
  run.run_for(kTime);
  double inertia = 0;
  for (int k = 0; k < kLength; ++k) inertia += (k + 0.5) * (k + 0.5) + 0.125;
  const double turning = kTime * (kLength * kLength / 2.0 - kMoment) / inertia;
  EXPECT_NEAR(run.world.disks.velocity[kLength].z(), -turning, 1e-3 * turning);
}

TEST(DefaultTolerance, LightGrainsCarryABodyAMillionTimesAsHeavy) {
  constexpr double kMass = 1e6;
  constexpr int kLight = 9;
  Scenario scene = column(Method::automatic, kLight + 1);
  scene.disks.back().density = kMass;
  Simulation run = with_default_tolerance(scene);
  for (int k = 0; k < 20; ++k) {
    run.advance(10);
    EXPECT_NEAR(contact_force_on(run.world, wall_body(0)).y(), -(kMass + kLight), 1e-4 * kMass);
  }
  EXPECT_NEAR(run.world.disks.position[kLight].y(), kLight + 0.5, kRange);
}

}  // namespace
}  // namespace quicksand
