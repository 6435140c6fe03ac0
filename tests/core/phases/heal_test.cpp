// Healing: bonds come back where contacts are.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/errors.h"
#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Healing);

constexpr double kCohesion = 50;

// Runs all phases and returns the end.
World finished(const Scenario& scene, const World& start) {
  Protocol protocol(scene, start);
  while (protocol.advance() != Progress::finished) {
  }
  return protocol.world();
}

World healed(Scenario scene, const World& start, const HealPhase& heal = {}) {
  scene.phases = {{heal}};
  return finished(scene, start);
}

// Bonded grains on the floor, all bonds broken.
World broken_column(const Scenario& scene) {
  World world = make_world(scene);
  for (Bond& bond : world.bonds.list) bond.state = BondState::broken;
  return world;
}

Scenario bonded_column(Method method, int n) {
  Scenario scene = column(method, n, paper_law(kCohesion));
  scene.initial_bonds = InitialBonds::touching;
  return scene;
}

std::int64_t active(const World& world) { return measure(world).bonds_active; }

TEST(Heal, RestoresEveryBrokenBondInTouchWithItsMark) {
  const Scenario scene = bonded_column(Method::automatic, 5);
  const World world = healed(scene, broken_column(scene));
  EXPECT_EQ(active(world), 5);
  EXPECT_EQ(world.bonds.healed, 5);
  EXPECT_EQ(world.bonds.formed, 5) << "healing is not forming";
  EXPECT_EQ(world.bonds.initial, 5);
  EXPECT_EQ(measure(world).remaining_bond_fraction, 1);
}

TEST(Heal, BondsTouchingPairsThatNeverWereBondedWithoutAMark) {
  Scenario scene = column(Method::automatic, 4, paper_law(kCohesion));
  const World world = healed(scene, make_world(scene));
  EXPECT_EQ(active(world), 4);
  for (const Bond& bond : world.bonds.list) EXPECT_FALSE(bond.initial);
  // Only the formerly bonded: there are none.
  EXPECT_EQ(active(healed(scene, make_world(scene), {.which = HealPhase::Which::broken})), 0);
}

TEST(Heal, LeavesPairsBeyondTheCohesionRangeAlone) {
  const Scenario scene = bonded_column(Method::automatic, 3);
  World world = broken_column(scene);
  const double range = scene.grain_law.cohesion_range;
  world.disks.position[2].y() += 1.01 * range;
  EXPECT_EQ(active(healed(scene, world)), 2);
  world.disks.position[2].y() -= 0.02 * range;
  EXPECT_EQ(active(healed(scene, world)), 3);
}

TEST(Heal, LeavesActiveBondsAsTheyAreAndCountsThemNot) {
  const Scenario scene = bonded_column(Method::automatic, 3);
  const World world = healed(scene, make_world(scene));
  EXPECT_EQ(active(world), 3);
  EXPECT_EQ(world.bonds.healed, 0);
}

TEST(Heal, OnlyPairsOfACohesiveLaw) {
  Scenario scene = column(Method::automatic, 3, paper_law(kCohesion));
  scene.wall_law = paper_law();
  const World world = healed(scene, make_world(scene));
  EXPECT_EQ(active(world), 2) << "and not the floor's";
  EXPECT_FALSE(world.bonds.find({0, kWallBase}));
}

TEST(Heal, TakesNoTimeAndMovesNothing) {
  const Scenario scene = bonded_column(Method::automatic, 3);
  const World start = broken_column(scene), end = healed(scene, start);
  EXPECT_EQ(end.time, start.time);
  EXPECT_EQ(end.step, start.step);
  EXPECT_EQ(end.disks.position, start.disks.position);
  EXPECT_EQ(end.random.state, start.random.state) << "nothing was drawn";
}

// 1 - exp(-1.2) of 4000 contacts, to four standard deviations.
TEST(Heal, RestoresTheShareThatTheWaitGivesTime) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = paper_law(kCohesion);
  constexpr int kContacts = 4000;
  for (int k = 0; k <= kContacts; ++k) scene.disks.push_back({.position = {double(k), 0}});
  const HealPhase heal{.waited = 6, .healing_time = 5};
  const World world = healed(scene, make_world(scene), heal);
  const double share = 1 - std::exp(-1.2), deviation = std::sqrt(share * (1 - share) / kContacts);
  EXPECT_NEAR(static_cast<double>(world.bonds.healed) / kContacts, share,
              tolerance::sampled(4 * deviation));
  EXPECT_EQ(world_hash(healed(scene, make_world(scene), heal)), world_hash(world));
  scene.seed = 2;
  EXPECT_NE(world_hash(healed(scene, make_world(scene), heal)), world_hash(world));
}

TEST(Heal, NothingHealsWithoutWaiting) {
  const Scenario scene = bonded_column(Method::automatic, 5);
  const HealPhase heal{.waited = 0, .healing_time = 1};
  EXPECT_EQ(healed(scene, broken_column(scene), heal).bonds.healed, 0);
}

// N = R_n + F_c dt from the first step on, which the broken contact's impulse has become: nothing is
// left to solve.
TEST_P(Healing, OfColumnAtRestGivesItsBondsTheirCohesionAtOnce) {
  Scenario scene = bonded_column(GetParam(), 4);
  scene.phases = {{SettlePhase{.max_time = 0.1, .until_rest = false}},
                  {HealPhase{}},
                  {SettlePhase{.max_time = 0.01, .until_rest = false}}};
  Protocol protocol(scene, broken_column(scene));
  while (protocol.advance() != Progress::finished) {
  }
  const World& world = protocol.world();
  EXPECT_EQ(active(world), 4);
  EXPECT_LE(measure(world).max_speed, tolerance::exact());
  for (int k = 1; k < 4; ++k) {
    const Contact& contact = *std::ranges::find(world.contacts, Pair{k - 1, k}, &Contact::pair);
    EXPECT_EQ(contact.cohesion, kCohesion);
    EXPECT_NEAR(contact.impulse.x() / world.impulse_dt, kCohesion + 4 - k, tolerance::solved(50));
  }
  EXPECT_EQ(protocol.last_step().solve.factorisations, 0);
}

TEST_P(Healing, GivesAPairItsStrengthBack) {
  for (const bool heals : {false, true}) {
    Scenario scene = pulled_pair(GetParam(), 0.9 * kCohesion, kCohesion);
    World world = make_world(scene);
    world.bonds.find({0, 1})->state = BondState::broken;
    if (heals) world = healed(scene, world);
    scene.phases = {{SettlePhase{.max_time = 0.1, .until_rest = false}}};
    world = finished(scene, world);
    EXPECT_EQ(world.gap({0, 1}) < scene.grain_law.cohesion_range, heals);
  }
}

TEST(Validation, RefusesToHealWhereNothingIsCohesive) {
  Scenario scene = column(Method::automatic, 3);
  scene.phases = {{HealPhase{}}};
  EXPECT_THROW(validate(scene), InputError);
  scene.wall_law = paper_law(1);
  EXPECT_NO_THROW(validate(scene));
}

}  // namespace
}  // namespace quicksand
