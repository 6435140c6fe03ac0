#include "core/solvers/local.h"

#include <gtest/gtest.h>

#include "core/problem/residual.h"
#include "core/scene/scenario.h"
#include "core/solvers/contact_solver.h"
#include "tests/support/core/random_heaps.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

TEST(LocalSolver, ASagOfAHangingChainIsTakenBackWithoutAFactorisation) {
  Simulation run(hanging_chain(Method::automatic, 300, 1e4));
  run.solver.tolerance = 1e-6;
  run.advance(4);  // the first step is far from any memory
  run.world.disks.velocity[300].y() = -1e-4;
  run.advance();
  EXPECT_EQ(run.last.solve.stage, SolverStage::local);
  EXPECT_EQ(run.last.solve.factorisations, 0);
  EXPECT_TRUE(run.last.converged);
  for (int k = 0; k < 300; ++k)
    ASSERT_NEAR(contact_force(run.world, {k, k + 1}).y(), 300 - k + 1e-4 / run.step.dt,
                tolerance::exact(1e4));
}

// Its places are not exact numbers. If the gaps that rounding opens were closed, every third step would
// take the impulses of the warm start, one would move and one would stop.
TEST(LocalSolver, AtRestEveryStepTakesTheWarmStart) {
  Simulation run(rotated(hanging_chain(Method::automatic, 300, 1e4), 0.3));
  run.solver.tolerance = 1e-6;
  run.advance(20);
  for (int k = 0; k < 100; ++k) {
    run.advance();
    ASSERT_EQ(run.last.solve.stage, SolverStage::start) << k;
  }
}

// The same steps of a collapsing packing solved over clusters and in full.
TEST(LocalSolver, GivesTheVelocitiesOfTheFullSolution) {
  Simulation run(falling_cluster(Method::automatic, 120, 3, paper_law(300)));
  run.world.bonding = true;
  run.solver.tolerance = 1e-9;
  SolverSettings full = run.solver;
  full.method = Method::interior_point;
  int local = 0, compared = 0;
  for (int k = 0; k < 400; ++k) {
    World other = run.world;
    Stepper stepper;
    const StepReport report = stepper.advance(other, run.step, full);
    run.advance();
    if (run.last.solve.stage != SolverStage::local || !report.converged) continue;
    ASSERT_TRUE(run.last.converged) << k;
    ++local;
    double worst = 0;
    for (std::size_t i = 0; i < other.disks.velocity.size(); ++i)
      worst = std::max(worst, distance(other.disks.velocity[i], run.world.disks.velocity[i]));
    // Friction may leave more than one solution; then the residual alone decides.
    if (worst <= tolerance::solved(10)) ++compared;
  }
  EXPECT_GE(local, 100) << "the local solver was hardly used";
  EXPECT_GE(compared, 95 * local / 100);
}

// What a much harder problem of the same step needed is not tried from the easy end again.
TEST(LocalSolver, IsNotTriedWhereTheCallerKnowsBetter) {
  Simulation run(hanging_chain(Method::automatic, 300, 1e4));
  run.advance(4);
  run.world.disks.velocity[300].y() = -1e-4;
  const ContactProblem problem = next_problem(run.world, run.step);
  ContactState start;
  for (const Contact& contact : run.world.contacts) start.impulse.push_back(contact.impulse);
  ContactState state = start;
  EXPECT_EQ(ContactSolver().solve(problem, run.solver, state).stage, SolverStage::local);
  state = start;
  const SolveReport told =
      ContactSolver().solve(problem, run.solver, state, SolverStage::interior_point);
  EXPECT_TRUE(told.converged);
  EXPECT_EQ(told.stage, SolverStage::interior_point);
}

TEST(LocalSolver, LeavesWhatItCannotSolveAsItWas) {
  // Without rolling friction nothing is rigid.
  Scenario scene = hanging_chain(Method::automatic, 20, 1e4);
  scene.grain_law.rolling_friction.reset();
  Simulation run(scene);
  run.advance(3);
  run.world.disks.velocity[20].y() = -1e-3;
  run.advance();
  EXPECT_NE(run.last.solve.stage, SolverStage::local);
  EXPECT_TRUE(run.last.converged);
}

}  // namespace
}  // namespace quicksand
