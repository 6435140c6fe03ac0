// The adaptive time step: no bonded pair turns farther in a step than max_turn.
#include <gtest/gtest.h>

#include <cmath>

#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/step/assemble.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(MaxTurn);
QUICKSAND_PER_SOLVER(ChangeOfStep);
QUICKSAND_PER_SOLVER(StarvedSolver);

constexpr double kStep = 1e-2;

Scenario limited(Scenario scene, std::optional<double> max_turn) {
  scene.step.dt = kStep;
  scene.step.max_turn = max_turn;
  scene.phases = {{SettlePhase{.max_time = 100, .until_rest = false}}};
  return scene;
}

double next_step(Protocol& protocol) {
  const double before = protocol.world().time;
  protocol.advance();
  return protocol.world().time - before;
}

// The step that a spinning pair takes; the first only makes its contact known.
double step_of_pair(Method method, double spin, std::optional<double> max_turn) {
  const Scenario scene = limited(spinning_pair(method, spin, 1e4), max_turn);
  Protocol protocol(scene, make_world(scene));
  protocol.advance();
  return next_step(protocol);
}

TEST_P(MaxTurn, StepsShrinkByPowersOfTwoAsAPairSpins) {
  constexpr double kMaxTurn = 0.05;
  for (double spin : {0.1, 4.0, 6.0, 12.0, 30.0, 90.0}) {
    const double dt = step_of_pair(GetParam(), spin, kMaxTurn);
    const double halvings = std::log2(kStep / dt);
    EXPECT_NEAR(halvings, std::round(halvings), tolerance::solved()) << spin;
    EXPECT_LE(spin * dt, kMaxTurn * (1 + tolerance::discretised())) << spin;
    // And no shorter than that needs.
    if (dt < 0.9 * kStep) {
      EXPECT_GT(2 * spin * dt, kMaxTurn * (1 - tolerance::discretised(10))) << spin;
    }
  }
}

TEST_P(MaxTurn, StepsAreFullWithoutALimitAndWhereAllIsQuiet) {
  EXPECT_NEAR(step_of_pair(GetParam(), 30, {}), kStep, tolerance::rounding());
  EXPECT_NEAR(step_of_pair(GetParam(), 4, 0.05), kStep, tolerance::rounding());
  Scenario chain = limited(hanging_chain(GetParam(), 10, 20), 1e-6);
  Protocol still(chain, make_world(chain));
  for (int k = 0; k < 10; ++k) EXPECT_NEAR(next_step(still), kStep, tolerance::rounding());
}

// Second order in the turn: by a radian a step the bond stays a tenth of a grain open.
TEST_P(MaxTurn, KeepsBondsShutThatATurnTooFarWouldLeaveOpen) {
  const auto widest = [](std::optional<double> max_turn) {
    Scenario scene = limited(spinning_pair(GetParam(), 100, 1e6), max_turn);
    Protocol protocol(scene, make_world(scene));
    for (int k = 0; k < 20; ++k) protocol.advance();
    EXPECT_EQ(protocol.world().bonds.broken, 0);
    return protocol.state().worst_bond_gap;
  };
  EXPECT_GT(widest({}), 0.01);
  EXPECT_LT(widest(0.05), kRange);
}

// Turning counts where a bond holds: neither a pair that rolls past each other without one ...
TEST_P(MaxTurn, StepsAreFullWhereNoBondTurns) {
  Scenario scene = limited(spinning_pair(GetParam(), 30, 1e4), 0.05);
  scene.initial_bonds = InitialBonds::none;
  Protocol unbonded(scene, make_world(scene));
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(next_step(unbonded), kStep, tolerance::rounding());
}

// ... nor a common motion, nor the spin of grains about themselves.
TEST_P(MaxTurn, StepsAreFullForABondedPairThatFliesOrTwists) {
  Scenario scene = limited(spinning_pair(GetParam(), 0, 1e4), 0.05);
  for (Disk& disk : scene.disks) disk.velocity = {50, 20};
  scene.disks[0].spin = 5, scene.disks[1].spin = -5;
  scene.grain_law.friction = 1e-6;
  scene.grain_law.rolling_friction = 1e-6;
  Protocol flying(scene, make_world(scene));
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(next_step(flying), kStep, tolerance::rounding());
}

// The step follows the spin as it decays, and the phase still lasts its time.
TEST_P(MaxTurn, StepsGrowAgainWhenThePairHasFlownApart) {
  Scenario scene = limited(spinning_pair(GetParam(), 40, 10), 0.05);
  scene.phases = {{SettlePhase{.max_time = 0.2, .until_rest = false}}};
  Protocol protocol(scene, make_world(scene));
  double last = 0;
  while (protocol.phase()) last = next_step(protocol);
  EXPECT_EQ(protocol.world().bonds.broken, 1);
  EXPECT_NEAR(last, kStep, tolerance::rounding());
  EXPECT_GE(protocol.world().time, 0.2 - tolerance::solved());
  EXPECT_LT(protocol.world().time, 0.2 + kStep);
}

// With max_turn the limit of a spinning pair is that of its closed form, at whatever step was asked for.
TEST_P(MaxTurn, ASmallTurnGivesThePairItsClosedForm) {
  for (double share : {0.99, 1.01}) {
    Scenario scene = limited(spinning_pair(GetParam(), std::sqrt(share * 2e4), 1e4), 0.05);
    // The first step does not yet know the contact.
    scene.phases = {{SettlePhase{.max_time = 1e-4, .until_rest = false}, 1e-5},
                    {SettlePhase{.max_time = 0.3, .until_rest = false}, kStep}};
    Protocol protocol(scene, make_world(scene));
    while (protocol.phase()) protocol.advance();
    EXPECT_EQ(protocol.world().bonds.broken, share > 1 ? 1 : 0) << share;
  }
}

// Bonds are known before any contact has been solved.
TEST_P(MaxTurn, TheFirstStepOfASceneIsLimitedToo) {
  const Scenario scene = limited(spinning_pair(GetParam(), std::sqrt(0.99 * 2e4), 1e4), 0.05);
  Protocol protocol(scene, make_world(scene));
  EXPECT_LT(next_step(protocol), 1e-3);
  EXPECT_EQ(protocol.world().bonds.broken, 0);
}

// Chain, cantilever and column: tension, bending and pressure. Impulses belong to a step; scaled to
// the next they solve it as they are. (Gaps do not scale: an error e of a gap is an acceleration e/dt^2
// in the next step, so that a jump to a thousandth of the step may need an iteration.)
TEST_P(ChangeOfStep, APackingAtRestStaysAtRestWithoutIterating) {
  for (const Scenario& scene : {hanging_chain(GetParam(), 10, 20), cantilever(GetParam(), 5, 400),
                                column(GetParam(), 10, paper_law(50))}) {
    Simulation run(scene);
    run.advance(5);
    ASSERT_EQ(run.unconverged, 0);
    run.solver.tolerance = 1e-6;
    for (double dt : {1e-2, 1e-3, 7e-3, 7e-4, 2e-4, 2e-2}) {
      run.step.dt = dt;
      run.advance();
      EXPECT_TRUE(run.last.converged);
      EXPECT_EQ(run.last.solve.iterations, 0) << dt;
      EXPECT_EQ(run.last.solve.factorisations, 0) << dt;
      for (const Vec3& v : run.world.disks.velocity) EXPECT_LE(v.norm(), tolerance::solved()) << dt;
    }
    EXPECT_EQ(run.bonds_broken, 0);
  }
}

// Loads that ask for breaks, and no work allowed to find out which.
TEST_P(StarvedSolver, NeverBreaksABondInAnUnconvergedStep) {
  for (int work : {0, 1, 2, 3, 5}) {
    for (double share : {0.5, 1.5, 20.0}) {
      Simulation run(hanging_chain(GetParam(), 60, 60 / share));
      forget_forces(run.world);
      run.solver.max_iterations = run.solver.max_factorisations = work;
      for (int k = 0; k < 20; ++k) {
        const std::int64_t before = run.bonds_broken;
        run.advance();
        if (!run.last.converged) {
          ASSERT_EQ(run.bonds_broken, before) << work << " " << share << " step " << k;
        }
      }
      // Gauss-Seidel and the shortest attempts never get there, and say so; where all sticks, the local solver
      // needs no more.
      if (work <= 1 && GetParam() != Method::automatic) {
        EXPECT_EQ(run.unconverged, 20) << work << " " << share;
        EXPECT_EQ(run.world.bonds.broken, 0);
      }
    }
  }
}

// The same through the protocol, which halves the steps or takes them as they are.
TEST_P(StarvedSolver, NeverBreaksABondInAnUnconvergedStepOfAProtocol) {
  for (int work : {1, 3, 10}) {
    for (bool stop : {false, true}) {
      Scenario scene = small_collapse(GetParam());
      scene.solver.max_iterations = scene.solver.max_factorisations = work;
      scene.step.stop_if_unconverged = stop;
      scene.step.max_halvings = 3;
      Protocol protocol(scene, make_world(scene));
      Progress progress = Progress::running;
      while (progress != Progress::finished && progress != Progress::failed) {
        progress = protocol.advance();
        if (!protocol.last_step().converged) {
          ASSERT_EQ(protocol.last_step().bonds_broken, 0) << "step " << protocol.world().step;
        }
      }
      EXPECT_EQ(protocol.state().broken_in_unconverged, 0);
      if (stop) {
        EXPECT_EQ(protocol.state().unconverged_steps, 0) << "none was taken";
      }
    }
  }
}

}  // namespace
}  // namespace quicksand
