#include "core/step/energy_criterion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/solvers/contact_solver.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

constexpr double kCohesion = 1e4;

// A hexagon of bonded disks, three rings around one that starts with this speed to the right.
Scenario struck_hexagon(double speed) {
  constexpr int kRings = 3;
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = paper_law(kCohesion);
  scene.initial_bonds = InitialBonds::touching;
  for (int row = -kRings; row <= kRings; ++row) {
    const int begin = std::max(-kRings, -kRings - row), end = std::min(kRings, kRings - row);
    for (int k = begin; k <= end; ++k)
      scene.disks.push_back({.position = {k + row / 2.0, row * std::sqrt(3.0) / 2},
                             .velocity = {row == 0 && k == 0 ? speed : 0, 0}});
  }
  return scene;
}

struct Outcome {
  std::vector<BondBreak> breaks;
  SolveReport cost;
};

// Of the first step, solved to 1e-9, with the criterion's own solution to `tolerance`.
Outcome failures_in_first_step(const Scenario& scene, double tolerance) {
  const World world = make_world(scene);
  std::vector<Pair> pairs;
  for (const Bond& bond : world.bonds.list) pairs.push_back(bond.pair);
  std::vector<Vec3> free;
  free_velocities(world, scene.step.dt, free);
  std::vector<Contact> contacts;
  find_contacts(world, pairs, free, scene.step.dt, contacts);
  ContactProblem problem;
  build_problem(world, contacts, free, scene.step, problem);
  ContactSolver solver;
  ContactState state;
  state.impulse.assign(contacts.size(), Vec3(0, 0, 0));
  SolverSettings settings = scene.solver;
  settings.tolerance = 1e-9;
  EXPECT_TRUE(solver.solve(problem, settings, state).converged);
  for (std::size_t c = 0; c < contacts.size(); ++c) contacts[c].impulse = state.impulse[c];

  Outcome outcome;
  outcome.cost.converged = true;
  settings.tolerance = tolerance;
  EnergyCriterion rule;
  outcome.breaks = rule.failures(world, contacts, scene.step, settings, solver, outcome.cost);
  EXPECT_TRUE(outcome.cost.converged);
  return outcome;
}

// Those in front take the blow: the bonds behind are pulled, but do not open without it.
TEST(EnergyCriterion, KeepsWhatHardlyOpens) {
  const Outcome outcome = failures_in_first_step(struck_hexagon(10), 1e-9);
  EXPECT_TRUE(outcome.breaks.empty());
  EXPECT_GT(outcome.cost.factorisations, 0) << "no bond was suspected";
}

// A hexagon that hangs from one of its corners: its sudden weight pulls, which is no impact, and the blow is faint.
TEST(EnergyCriterion, ClearsByARoughSolutionWhatALoadPulls) {
  Scenario scene = struck_hexagon(0.3);
  scene.solver.method = Method::interior_point;
  scene.disks[0].fixed = true;
  scene.gravity = Vec2(100, 0);
  const Outcome outcome = failures_in_first_step(scene, 1e-9);
  EXPECT_TRUE(outcome.breaks.empty());
  EXPECT_GT(outcome.cost.factorisations, 0) << "no bond was suspected";
  EXPECT_EQ(failures_in_first_step(scene, 1e-6).cost.factorisations, outcome.cost.factorisations)
      << "it was solved to the tolerance";
}

// A row on a fixed disk, each faster than the one before, as if pulled long: the bond to the fixed disk, the
// only weak one, must hold all of their momentum J, and opens with the speed J/n if it does not. The criterion's solution
// starts from no load, which is no solution, however roughly it is to be solved.
TEST(EnergyCriterion, BreaksWhatManyPullTogether) {
  constexpr int kRow = 50;
  constexpr double kEnergy = kCohesion * kRange;
  for (const double share : {0.5, 2.0, 8.0}) {
    const double momentum = std::sqrt(2 * share * kEnergy * kRow);
    Scenario scene = empty_scene(Method::automatic);
    scene.grain_law = {.cohesion_force = kCohesion, .cohesion_range = 0.05};
    scene.intruder_law = ContactLaw{.cohesion_force = kCohesion, .cohesion_range = kRange};
    scene.initial_bonds = InitialBonds::touching;
    scene.disks = {{.position = {0, 0}, .role = DiskRole::intruder, .fixed = true}};
    for (int k = 1; k <= kRow; ++k)
      scene.disks.push_back(
          {.position = {k, 0}, .velocity = {2 * momentum * k / (kRow * (kRow + 1)), 0}});
    EXPECT_EQ(failures_in_first_step(scene, 1e-6).breaks.size(), share > 1 ? 1U : 0U) << share;
    Simulation run(scene);
    run.advance();
    EXPECT_EQ(run.bonds_broken, share > 1 ? 1 : 0) << share;
  }
}

// A free pair that parts at this speed.
Scenario parting_pair(double speed) {
  Scenario scene = struck_hexagon(0);
  scene.disks.resize(2);
  scene.disks[0].velocity = {-speed, 0};
  return scene;
}

// It parts with J = m_red u and the energy J u/2, of which the bond takes its own, E = F_c d_c.
TEST(EnergyCriterion, GivesWhatBreaksTheImpulseThatTakesItsEnergy) {
  const double energy = kCohesion * kRange;
  for (const double share : {1.05, 2.0, 50.0}) {
    const double speed = std::sqrt(4 * share * energy), impulse = speed / 2;
    const Scenario scene = parting_pair(speed);
    const Outcome outcome = failures_in_first_step(scene, 1e-9);
    ASSERT_EQ(outcome.breaks.size(), 1U) << share;
    const double last = impulse * (1 - std::sqrt(1 - 1 / share)) / scene.step.dt;
    EXPECT_NEAR(outcome.breaks[0].last_force, last, tolerance::solved(last)) << share;
  }
  for (const double share : {0.55, 0.95})
    EXPECT_TRUE(
        failures_in_first_step(parting_pair(std::sqrt(4 * share * energy)), 1e-9).breaks.empty())
        << share;
}

}  // namespace
}  // namespace quicksand
