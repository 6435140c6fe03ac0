// Gauss-Seidel where it is needed: the same solution for less work.
#include "core/sweeps/relaxation.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/problem/residual.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/sweeps/gauss_seidel.h"
#include "core/world/ballistic.h"
#include "tests/support/core/agreement.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

SolveReport relax(const ContactProblem& problem, const SolverSettings& settings,
                  ContactState& state) {
  RelaxationScratch scratch;
  return solve_relaxation(problem, settings, state, scratch);
}

// `columns` columns of two disks on the ground, each disk about to fall through what is below it.
ContactProblem columns(int columns) {
  ContactProblem problem{.dt = 1, .components = 1};
  problem.inverse_mass.push_back({0, 0, 0});
  problem.free_velocity.push_back({0, 0, 0});
  for (int k = 0; k < columns; ++k) {
    int below = 0;
    for (int disk = 0; disk < 2; ++disk) {
      const int above = static_cast<int>(problem.inverse_mass.size());
      problem.inverse_mass.push_back({1, 1, 8});
      problem.free_velocity.push_back({0, -1, 0});
      problem.contacts.push_back({.a = below,
                                  .b = above,
                                  .normal = {0, 1},
                                  .gap_tolerance = std::numeric_limits<double>::infinity()});
      below = above;
    }
  }
  return problem;
}

TEST(Relaxation, SolvesAColumnExactly) {
  const ContactProblem problem = columns(1);
  ContactState state = zero_state(problem);
  const SolveReport report = relax(problem, {.tolerance = 1e-11}, state);
  EXPECT_TRUE(report.converged);
  EXPECT_FALSE(report.velocity_change) << "nothing tells how far velocities are from settled";
  EXPECT_NEAR(state.impulse[0].x(), 2, 1e-10);
  EXPECT_NEAR(state.impulse[1].x(), 1, 1e-10);
}

// One of a thousand columns is off; sweeps go over all of them each time.
TEST(Relaxation, LooksOnlyWhereTheLawIsViolated) {
  const ContactProblem problem = columns(1000);
  ContactState start = zero_state(problem);
  for (std::size_t c = 0; c < start.impulse.size(); ++c) start.impulse[c].x() = c % 2 == 0 ? 2 : 1;
  start.impulse[0].x() = 0;
  const SolverSettings settings{.tolerance = 1e-10};
  ContactState state = start;
  const SolveReport relaxed = relax(problem, settings, state);
  EXPECT_TRUE(relaxed.converged);
  EXPECT_LE(relaxed.iterations, 2);
  state = start;
  const SolveReport swept = solve_gauss_seidel(problem, settings, state);
  EXPECT_TRUE(swept.converged);
  EXPECT_GE(swept.iterations, 20);
}

TEST(Relaxation, HasTheVelocitiesOfTheReference) {
  Random random{1};
  int compared = 0;
  for (int k = 0; k < 200; ++k) {
    const ContactProblem problem =
        random_problem({.bodies = 4, .contacts = 3, .components = 3}, random);
    const auto reference = reference_solutions(problem);
    if (!reference.complete || reference.solutions.size() != 1) continue;
    ContactState state = zero_state(problem);
    if (!relax(problem, tight(Method::gauss_seidel), state).converged) continue;
    ++compared;
    EXPECT_LE(distance_to_nearest(reference.solutions, state.velocity), tolerance::solved());
  }
  EXPECT_GE(compared, 60);
}

TEST(Relaxation, EndsWhereItIsNotAllowedToWorkOrCannot) {
  const ContactProblem problem = columns(10);
  for (const int sweeps : {-1, 0, 1}) {
    ContactState state = zero_state(problem);
    const SolveReport report =
        relax(problem, {.tolerance = 1e-11, .max_iterations = sweeps}, state);
    EXPECT_FALSE(report.converged);
    EXPECT_EQ(report.iterations, std::max(0, sweeps));
    EXPECT_EQ(report.residual.natural, residual(problem, state).natural);
  }
  ContactProblem broken = problem;
  broken.free_velocity[1].y() = std::numeric_limits<double>::quiet_NaN();
  ContactState state = zero_state(broken);
  EXPECT_FALSE(relax(broken, {.tolerance = 1e-11}, state).converged);
  broken.contacts.clear();
  state = zero_state(broken);
  EXPECT_FALSE(relax(broken, {.tolerance = 1e-11}, state).converged) << "nothing to work on";
}

// While a loose heap falls in, some contacts stay undecided to the end of the interior point's path, long after
// velocities have settled.
TEST(Relaxation, EndsTheLongPathsOfACollapse) {
  Scenario heap = empty_scene(Method::automatic);
  heap.box = {.width = 25, .height = 100, .sides = Sides::periodic, .floor = true};
  heap.gravity = Vec2(0, -1);
  heap.grain_law = paper_law();
  heap.wall_law = paper_law();
  heap.solver.tolerance = 1e-5;
  World deposit = make_world(heap);
  for (int k = 0; k < 500; ++k) {
    const Vec2 place = LandingSite(deposit).land(25 * deposit.random.uniform(), 0.5)->centre;
    deposit.disks.add({.position = place});
    heap.disks.push_back({.position = place});
  }
  Simulation run(heap);
  run.advance(400);
  std::int64_t factorisations = 0;
  constexpr int kSteps = 100;
  for (int k = 0; k < kSteps; ++k) {
    run.advance();
    factorisations += run.last.solve.factorisations;
  }
  EXPECT_EQ(run.unconverged, 0);
  EXPECT_LE(factorisations, 15 * kSteps) << "17.2 a step without, 12.6 with it";
}

}  // namespace
}  // namespace quicksand
