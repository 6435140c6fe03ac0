#include "core/step/step.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Step);

TEST_P(Step, CountsStepsAndTime) {
  Simulation run(column(GetParam(), 2));
  run.advance(3);
  EXPECT_EQ(run.world.step, 3);
  EXPECT_NEAR(run.world.time, 3 * run.step.dt, tolerance::rounding());
  EXPECT_EQ(run.world.impulse_dt, run.step.dt);
}

TEST_P(Step, BodiesThatMeetDoNotOverlap) {
  Scenario scene = falling_cluster(GetParam(), 25, 9, paper_law());
  scene.solver.tolerance = 1e-8;
  Simulation run(scene);
  for (int k = 0; k < 300; ++k) {
    run.advance();
    if (!run.last.converged) continue;
    for (const Contact& contact : run.world.contacts)
      ASSERT_GE(run.world.gap(contact.pair), -1e-4) << "in step " << k;
  }
}

// A grain hit by a fast one moves into a third that was out of reach for all free velocities.
TEST_P(Step, FindsContactsThatOnlyAnotherContactCauses) {
  Scenario scene = empty_scene(GetParam());
  scene.disks = {
      {.position = {0, 0}, .velocity = {40, 0}}, {.position = {1, 0}}, {.position = {2.1, 0}}};
  Simulation run(scene);
  run.advance();
  EXPECT_GE(run.world.gap({1, 2}), -1e-6);
  EXPECT_GT(run.world.disks.velocity[2].x(), 1) << "the third must have been hit";
}

// What is repeated with half the time step need not be solved again with what its lost solution would hit.
TEST(Patience, ALostStepIsNotSolvedAgain) {
  const auto sweeps = [](bool stop_if_unconverged) {
    Scenario scene = hanging_chain(Method::gauss_seidel, 60, 3);
    for (const double x : {50.0, 51.0, 52.1}) scene.disks.push_back({.position = {x, 0}});
    scene.disks[scene.disks.size() - 3].velocity = {40, 0};
    Simulation run(scene);
    run.solver.max_iterations = 1;
    run.step.stop_if_unconverged = stop_if_unconverged;
    run.advance();
    EXPECT_FALSE(run.last.converged);
    return run.last.solve.iterations;
  };
  EXPECT_EQ(sweeps(true), 1);
  EXPECT_GE(sweeps(false), 2);
}

TEST_P(Step, AVelocityThatIsNotFiniteStopsBeforeTheWorldIsTouched) {
  Simulation run(column(GetParam(), 3));
  run.advance(2);
  constexpr double kTooFast = 1e160;  // the square is infinite, and with it all distances searched
  for (const double force : {std::numeric_limits<double>::quiet_NaN(), kTooFast}) {
    run.world.disks.applied[1].y() = force;
    const std::uint64_t before = world_hash(run.world);
    run.advance();
    EXPECT_FALSE(run.last.finite);
    EXPECT_FALSE(run.last.taken);
    EXPECT_EQ(run.last.bad_body, 1);
    EXPECT_EQ(world_hash(run.world), before);
  }
}

TEST_P(Step, AStepThatMustConvergeAndDoesNotIsNotTaken) {
  Simulation run(hanging_chain(GetParam(), 60, 3));
  forget_forces(run.world);
  run.step.stop_if_unconverged = true;
  run.solver.max_iterations = run.solver.max_factorisations = 1;
  const std::uint64_t before = world_hash(run.world);
  run.advance();
  EXPECT_FALSE(run.last.converged);
  EXPECT_FALSE(run.last.taken);
  EXPECT_EQ(world_hash(run.world), before);
}

// Where a step can be halved, that is cheaper than to go on with it.
TEST(Patience, EndsSoonerWhereTheStepCanBeHalved) {
  const auto sweeps = [](bool patient) {
    Simulation run(hanging_chain(Method::automatic, 200, 3));
    forget_forces(run.world);
    run.solver.max_factorisations = 1;  // so that relaxation has to do it, and cannot
    run.solver.patient = patient;
    run.step.stop_if_unconverged = true;
    run.advance();
    EXPECT_FALSE(run.last.converged);
    return run.last.solve.iterations;
  };
  EXPECT_LE(sweeps(false), 2 * 300);
  EXPECT_GE(sweeps(true), 2 * 1000);
}

// In the shortest step of a shock another start may find what the first two have not.
TEST(Patience, TriesMoreStartsWhereTheStepCannotBeHalved) {
  const auto attempts = [](bool patient) {
    Simulation run(hanging_chain(Method::automatic, 200, 3));
    forget_forces(run.world);
    run.solver.max_factorisations = 1;  // of each attempt
    run.solver.patient = patient;
    run.step.stop_if_unconverged = true;
    run.advance();
    return run.last.solve.factorisations;
  };
  EXPECT_EQ(attempts(false), 2);
  EXPECT_EQ(attempts(true), 6);
}

TEST_P(Step, SettingsLimitTheWork) {
  Simulation run(hanging_chain(GetParam(), 60, 3));
  run.solver.max_iterations = 3;
  run.solver.max_factorisations = 2;
  run.advance();
  EXPECT_LE(run.last.solve.iterations, 3);
  // The fallback chain has six attempts where there are no halves.
  EXPECT_LE(run.last.solve.factorisations, 12);
}

TEST_P(Step, ASteppersPastDoesNotMatter) {
  const Scenario scene = falling_cluster(GetParam(), 12, 3, paper_law(10));
  World fresh = make_world(scene), used = make_world(scene);
  Stepper one, other;
  World elsewhere = make_world(falling_cluster(GetParam(), 30, 8, paper_law()));
  for (int k = 0; k < 5; ++k) other.advance(elsewhere, scene.step, scene.solver);
  for (int k = 0; k < 40; ++k) {
    one.advance(fresh, scene.step, scene.solver);
    other.advance(used, scene.step, scene.solver);
    ASSERT_EQ(world_hash(fresh), world_hash(used)) << "after step " << k;
  }
}

// Pairs that meet head on close four times the way of one of them in a step; which of them a list holds must
// not decide.
TEST_P(Step, ASteppersPastDoesNotMatterForPairsThatMeetHeadOn) {
  Random random{7};
  Scenario scene = falling_cluster(GetParam(), 12, 3, paper_law(10));
  for (int k = 0; k < 12; ++k) {
    const double speed = 6 + random.uniform(), gap = 0.3 + 2 * random.uniform();
    scene.disks.push_back({.position = {0, 50 + 2.0 * k}, .velocity = {speed, 0}});
    scene.disks.push_back({.position = {1 + gap, 50 + 2.0 * k}, .velocity = {-speed, 0}});
  }
  World kept = make_world(scene), anew = make_world(scene);
  Stepper one;
  for (int k = 0; k < 60; ++k) {
    one.advance(kept, scene.step, scene.solver);
    Stepper().advance(anew, scene.step, scene.solver);
    ASSERT_EQ(world_hash(kept), world_hash(anew)) << "after step " << k;
  }
}

// A blow that runs through more disks than a step looks for: the step is not exact, and says so.
TEST_P(Step, ThatMissesMoreAndMoreContactsIsNotConverged) {
  Scenario scene = empty_scene(GetParam());
  scene.step.stop_if_unconverged = false;
  for (int k = 0; k < 60; ++k)
    scene.disks.push_back({.position = {k * 1.006, 0}, .velocity = {k == 0 ? 1000.0 : 0, 0}});
  Simulation run(scene);
  run.advance();
  EXPECT_FALSE(run.last.converged);
  EXPECT_TRUE(run.last.taken);
  EXPECT_LT(run.world.contacts.size(), 59U) << "those that were solved";
  EXPECT_GT(run.world.contacts.back().impulse.x(), 0) << "none that was not solved";
}

// A range made shorter than a bond is wide, as by a scene that starts from another's state.
TEST_P(Step, BreaksABondThatIsWiderThanItsRange) {
  for (const double gap : {0.002, 0.1, 0.3, 5.0}) {
    Scenario scene = empty_scene(GetParam());
    scene.grain_law = {.cohesion_force = 10, .cohesion_range = 6};
    scene.disks = {{.position = {0, 0}, .fixed = true}, {.position = {1 + gap, 0}}};
    scene.initial_bonds = InitialBonds::touching;
    Simulation run(scene);
    scene.grain_law.cohesion_range = 1e-4;
    take_laws(run.world, scene);
    run.advance();
    EXPECT_EQ(run.bonds_broken, 1) << gap;
  }
}

// A pair that drifts together slowly enters the list late, when a new stepper would already see it.
TEST_P(Step, ASteppersPastDoesNotMatterForPairsThatComeSlowly) {
  Scenario scene = empty_scene(GetParam());
  scene.disks = {{.position = {0, 0}, .velocity = {0.1, 0}},
                 {.position = {1.2505, 0}, .velocity = {-0.1, 0}}};
  World world = make_world(scene);
  Stepper old;
  for (int k = 0; k < 140; ++k) {
    World branch = world;
    Stepper().advance(branch, scene.step, scene.solver);
    old.advance(world, scene.step, scene.solver);
    ASSERT_EQ(world_hash(branch), world_hash(world)) << "in step " << k;
  }
}

TEST(BondOfBodiesThatNoForceMoves, BreaksWhereTheyAreLedApart) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = paper_law(10);
  scene.step.dt = 1e-2;
  scene.disks = {{.position = {0, 0}, .fixed = true},
                 {.position = {1, 0}, .fixed = true},
                 {.position = {2, 0}, .velocity = {1, 0}, .fixed = true}};
  Simulation run(scene);
  run.world.bonds.form({{0, 1}, {1, 2}});
  run.advance(3);
  EXPECT_EQ(run.world.bonds.list[0].state, BondState::active);
  EXPECT_EQ(run.world.bonds.list[1].state, BondState::broken);
  EXPECT_EQ(run.world.bonds.broken, 1);
}

}  // namespace
}  // namespace quicksand
