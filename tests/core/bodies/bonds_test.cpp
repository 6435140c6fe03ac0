#include "core/bodies/bonds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"

namespace quicksand {
namespace {

TEST(BondList, StaysSortedAndFindsWhatWasFormed) {
  Bonds bonds;
  bonds.form({{2, 5}, {3, 4}});
  bonds.form({{0, 9}, {2, 6}, {7, kWallBase}});
  EXPECT_TRUE(std::ranges::is_sorted(bonds.list, {}, &Bond::pair));
  EXPECT_EQ(bonds.formed, 5);
  for (Pair pair : {Pair{2, 5}, Pair{0, 9}, Pair{7, kWallBase}})
    ASSERT_TRUE(bonds.find(pair)) << pair.a << " " << pair.b;
  EXPECT_FALSE(bonds.find({2, 7}));
}

TEST(BondList, OnlyActiveBondsAreInitialOnes) {
  Bonds bonds;
  bonds.form({{0, 1}, {1, 2}});
  bonds.find({0, 1})->state = BondState::broken;
  bonds.mark_initial();
  EXPECT_EQ(bonds.initial, 1);
  EXPECT_FALSE(bonds.find({0, 1})->initial);
  // Marking again forgets the first marks.
  bonds.find({1, 2})->state = BondState::broken;
  bonds.mark_initial();
  EXPECT_EQ(bonds.initial, 0);
  EXPECT_FALSE(bonds.find({1, 2})->initial);
}

QUICKSAND_PER_SOLVER(BondMemory);

// Two grains on their way to each other.
Scenario collision(Method method) {
  Scenario scene = empty_scene(method);
  scene.grain_law = paper_law(10);
  scene.disks = {{.position = {0, 0}, .velocity = {1, 0}}, {.position = {1.1, 0}}};
  return scene;
}

TEST_P(BondMemory, ABondFormsAtTheFirstTouchWhileBondingIsOn) {
  Simulation run(collision(GetParam()));
  run.world.bonding = true;
  run.run_for(0.08);
  EXPECT_EQ(run.bonds_formed, 0) << "not yet in touch";
  run.run_for(0.1);
  EXPECT_EQ(run.bonds_formed, 1);
  ASSERT_TRUE(run.world.bonds.find({0, 1}));
  EXPECT_EQ(run.world.bonds.find({0, 1})->state, BondState::active);
}

TEST_P(BondMemory, NoBondFormsWhileBondingIsOff) {
  Simulation run(collision(GetParam()));
  run.run_for(0.2);
  EXPECT_GT(run.world.disks.velocity[1].x(), 0) << "they must have touched";
  EXPECT_EQ(run.bonds_formed, 0);
}

TEST_P(BondMemory, NoBondFormsWithoutACohesiveLaw) {
  Scenario scene = collision(GetParam());
  scene.grain_law.cohesion_force.reset();
  Simulation run(scene);
  run.world.bonding = true;
  run.run_for(0.2);
  EXPECT_EQ(run.bonds_formed, 0);
}

// Pulls a bonded pair apart and pushes it together again, with bonding on all the time.
TEST_P(BondMemory, ABrokenBondNeverComesBack) {
  Simulation run(pulled_pair(GetParam(), 20, 10));
  run.world.bonding = true;
  run.run_for(0.2);
  ASSERT_EQ(run.bonds_broken, 1);
  run.world.disks.applied[1].x() = -20;
  run.run_for(1);
  EXPECT_LT(run.world.gap({0, 1}), 1e-6) << "they must touch again";
  EXPECT_EQ(run.bonds_formed, 0);
  EXPECT_EQ(run.world.bonds.find({0, 1})->state, BondState::broken);
  // And it holds nothing any more.
  run.world.disks.applied[1].x() = 1;
  run.run_for(0.1);
  EXPECT_GT(run.world.gap({0, 1}), 1e-3);
  EXPECT_EQ(run.bonds_broken, 1);
}

// Too heavy a chain, and far too little work allowed to find out.
TEST_P(BondMemory, NoBondBreaksInAStepThatDidNotConverge) {
  Simulation run(hanging_chain(GetParam(), 60, 3));
  run.solver.max_iterations = run.solver.max_factorisations = 1;
  run.solver.tolerance = 1e-18;  // out of reach
  run.run_for(0.1);
  EXPECT_EQ(run.unconverged, 10);
  EXPECT_GT(run.breaks_withheld, 0);
  EXPECT_EQ(run.bonds_broken, 0);
  for (const Bond& bond : run.world.bonds.list) EXPECT_EQ(bond.state, BondState::active);
}

}  // namespace
}  // namespace quicksand
