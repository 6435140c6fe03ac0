// Closed forms of structures so long that a solver's error adds up along them.

#include "core/problem/solver_settings.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_GLOBAL_SOLVER(LongChain);
QUICKSAND_PER_GLOBAL_SOLVER(LongCantilever);
QUICKSAND_PER_GLOBAL_SOLVER(TallColumn);

// A residual is local, and a chain adds up what it leaves: if every contact may be wrong by
// tolerance * F_c, the forces of a chain of n may be wrong by n^2 times that; hence a tolerance for which
// this does not matter. What the default one gives is in default_tolerance_test.cpp.
double tolerance_for(int n) { return 1e-3 / n / n; }

// n grains below the first bond: it carries n m g. An overloaded bond opens with the share of g that is
// missing, by d_c within sqrt(2 d_c/0.0099 g) = 0.1: ten steps and some more.
Simulation loaded_chain(Method method, int n, double share) {
  Scenario scene = hanging_chain(method, n, n / share);
  scene.solver.tolerance = tolerance_for(n);
  Simulation run(scene);
  run.advance(20);
  EXPECT_EQ(run.unconverged, 0);
  return run;
}

void expect_holds_below_its_limit(Method method, int n) {
  const Simulation run = loaded_chain(method, n, 0.99);
  EXPECT_EQ(run.bonds_broken, 0);
  EXPECT_NEAR(run.world.disks.position[n].y(), -n, kRange) << "sag of the whole chain";
  for (int k = 0; k < n; ++k)
    ASSERT_NEAR(contact_force(run.world, {k, k + 1}).y(), n - k, tolerance::discretised(n)) << k;
}

void expect_breaks_above_its_limit(Method method, int n) {
  const Simulation run = loaded_chain(method, n, 1.01);
  EXPECT_EQ(run.bonds_broken, 1);
  EXPECT_EQ(run.world.bonds.find({0, 1})->state, BondState::broken);
  // The first bond gives way before the next are loaded to their limit: the rest falls as one.
  EXPECT_NEAR(run.world.disks.position[n].y() - run.world.disks.position[1].y(), 1 - n, kRange);
}

TEST_P(LongChain, OfAHundredHoldsBelowItsLimit) { expect_holds_below_its_limit(GetParam(), 100); }
TEST_P(LongChain, OfAThousandHoldsBelowItsLimit) { expect_holds_below_its_limit(GetParam(), 1000); }
TEST_P(LongChain, OfAHundredBreaksAtTheTopAboveItsLimit) {
  expect_breaks_above_its_limit(GetParam(), 100);
}
TEST_P(LongChain, OfAThousandBreaksAtTheTopAboveItsLimit) {
  expect_breaks_above_its_limit(GetParam(), 1000);
}

// Here the tolerance is where the interior point alone runs out of digits.
TEST(VeryLongChain, SlowOfTenThousandHoldsBelowItsLimit) {
  expect_holds_below_its_limit(Method::automatic, 10000);
}
TEST(VeryLongChain, SlowOfTenThousandBreaksAtTheTopAboveItsLimit) {
  expect_breaks_above_its_limit(Method::automatic, 10000);
}

TEST_P(LongChain, ForcesAreRightToTheToleranceTimesTheLengthSquared) {
  for (int n : {30, 100, 300, 1000}) {
    for (double tolerance : {1e-6, 1e-8}) {
      if (n * n * tolerance > 0.1) continue;  // breaks below its limit
      Scenario scene = hanging_chain(GetParam(), n, n / 0.9);
      scene.solver.tolerance = tolerance;
      Simulation run(scene);
      run.advance(20);
      EXPECT_EQ(run.bonds_broken, 0);
      for (int k = 0; k < n; ++k)
        ASSERT_NEAR(contact_force(run.world, {k, k + 1}).y(), n - k,
                    tolerance::sampled(0.1 * n * n * tolerance * n))
            << k << " of " << n << " at " << tolerance;
    }
  }
}

// The moment of n grains about the first contact, n^2/2 d m g, against mu_r F_c with mu_r = 0.05 d.
Simulation loaded_cantilever(Method method, int n, double cohesion, double dt, double time) {
  Scenario scene = cantilever(method, n, cohesion);
  scene.step.dt = dt;
  Simulation run(scene);
  run.run_for(time);
  EXPECT_EQ(run.unconverged, 0);
  EXPECT_EQ(run.bonds_broken, 0);
  return run;
}

double tip(const Simulation& run) { return run.world.disks.position.back().y(); }

TEST_P(LongCantilever, OfThirtyOneHoldsForLong) {
  const Simulation run = loaded_cantilever(GetParam(), 31, 1e4, 1e-2, 5);
  EXPECT_NEAR(tip(run), 0, tolerance::solved());
}

TEST_P(LongCantilever, OfThirtyTwoTurnsWithWhatRollingFrictionLeaves) {
  // About the first contact: the arms are 1/2, 3/2, ..., the inertia of a grain is 1/8.
  double inertia = 0;
  for (int k = 0; k < 32; ++k) inertia += (k + 0.5) * (k + 0.5) + 0.125;
  const double acceleration = (32 * 32 / 2.0 - 0.05 * 1e4) / inertia;
  for (double dt : {1e-2, 1e-3}) {
    constexpr double kTime = 0.1;
    const Simulation run = loaded_cantilever(GetParam(), 32, 1e4, dt, kTime);
    EXPECT_NEAR(-run.world.disks.velocity[32].z(), acceleration * kTime,
                tolerance::discretised(acceleration * kTime))
        << dt;
  }
}

// Of bending the errors of the contacts add up to n^4 times the tolerance, as an acceleration: what it
// does within the first steps is proportional to dt^2, 0.017 d at 1e-2 and 1.7e-4 d at 1e-3. Then it
// rests. (One of 32 falls four times as far as it should at 1e-2. The interior point alone takes over
// what is within its tolerance and creeps on, by 7 dt^2 in 200 steps.)
TEST(DefaultCantilever, OfThirtyOneSinksAtTheDefaultToleranceOnceAndRests) {
  for (double dt : {1e-2, 1e-3}) {
    Scenario scene = cantilever(Method::automatic, 31, 1e4);
    scene.solver.tolerance = SolverSettings{}.tolerance;
    scene.step.dt = dt;
    Simulation run(scene);
    run.advance(100);
    const double sunk = tip(run);
    EXPECT_NEAR(sunk, 0, tolerance::sampled(250 * dt * dt)) << dt;
    run.advance(200);
    EXPECT_NEAR(tip(run), sunk, tolerance::sampled(5 * dt * dt)) << dt;
    EXPECT_EQ(run.unconverged, 0);
    EXPECT_EQ(run.bonds_broken, 0);
  }
}

TEST_P(LongCantilever, OfSixtyHoldsAndYieldsWithinOnePercentOfItsLimit) {
  const double limit = 60 * 60 / 2.0 / 0.05;
  EXPECT_NEAR(tip(loaded_cantilever(GetParam(), 60, limit / 0.99, 1e-2, 1)), 0,
              tolerance::solved());
  EXPECT_LT(tip(loaded_cantilever(GetParam(), 60, limit / 1.01, 1e-2, 1)), -5e-3);
}

TEST_P(TallColumn, OfAThousandStandsWithoutDrift) {
  constexpr int n = 1000;
  for (double cohesion : {0.0, 50.0}) {
    Scenario scene = column(GetParam(), n, paper_law(cohesion));
    scene.initial_bonds = InitialBonds::touching;
    Simulation run(scene);
    run.advance(1000);
    EXPECT_EQ(run.unconverged, 0);
    EXPECT_EQ(run.bonds_broken, 0);
    EXPECT_NEAR(contact_force(run.world, {0, wall_body(0)}).norm(), n, tolerance::exact(n));
    for (int k = 1; k < n; ++k)
      ASSERT_NEAR(contact_force(run.world, {k - 1, k}).norm(), n - k, tolerance::exact(n)) << k;
    for (int k = 0; k < n; ++k) {
      ASSERT_LE(distance(run.world.disks.position[k], Vec2(0, 0.5 + k)), tolerance::exact()) << k;
      ASSERT_LE(run.world.disks.velocity[k].norm(), tolerance::exact()) << k;
    }
  }
}

}  // namespace
}  // namespace quicksand
