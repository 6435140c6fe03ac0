#include "core/step/assemble.h"

#include <gtest/gtest.h>

#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

// Two unequal disks and a floor; disk 1 touches disk 0, which touches the floor.
Scenario pile() {
  Scenario scene = empty_scene(Method::automatic);
  scene.box.floor = true;
  scene.gravity = Vec2(0, -1);
  scene.grain_law = {.friction = 0.3, .rolling_friction = 0.2, .cohesion_force = 7};
  scene.wall_law = ContactLaw{.friction = 0.9};
  scene.disks = {{.position = {0, 2}, .radius = 2},
                 {.position = {0, 5}, .radius = 1, .density = 2}};
  scene.initial_bonds = InitialBonds::touching;
  return scene;
}

struct Built {
  World world;
  std::vector<Vec3> free;
  std::vector<Contact> contacts;
  ContactProblem problem;
};

Built build(const Scenario& scene, const std::vector<Pair>& candidates) {
  Built b{.world = make_world(scene), .free = {}, .contacts = {}, .problem = {}};
  free_velocities(b.world, scene.step.dt, b.free);
  find_contacts(b.world, candidates, b.free, scene.step.dt, b.contacts);
  build_problem(b.world, b.contacts, b.free, scene.step, b.problem);
  return b;
}

const std::vector<Pair> kPilePairs{{0, 1}, {0, kWallBase}};

// Of the pile, in a step of dt.
std::vector<Contact> pile_contacts(const World& world, double dt) {
  std::vector<Vec3> free;
  free_velocities(world, dt, free);
  std::vector<Contact> contacts;
  find_contacts(world, kPilePairs, free, dt, contacts);
  return contacts;
}

TEST(ContactProblem, FreeVelocitiesAreThoseWithoutContactsAndBonds) {
  Scenario scene = pile();
  scene.disks[1].fixed = true;
  scene.disks[1].velocity = {3, 4};
  scene.disk_forces = {Vec3(16, 0, 32)};
  scene.walls = {{.normal = {0, -1}, .mass = 2, .force = 4}};
  scene.initial_bonds = InitialBonds::none;
  const World world = make_world(scene);
  std::vector<Vec3> v;
  free_velocities(world, 0.1, v);
  ASSERT_EQ(v.size(), 4U);
  EXPECT_LE(distance(v[0], Vec3(0.1, -0.1, 0.1)), tolerance::rounding());  // m 16, I 32
  EXPECT_EQ(distance(v[1], Vec3(3, 4, 0)), 0) << "fixed";
  EXPECT_EQ(distance(v[2], Vec3(0, 0, 0)), 0) << "the floor";
  EXPECT_LE(distance(v[3], Vec3(0, -0.3, 0)), tolerance::rounding()) << "weight and force";
}

TEST(ContactProblem, RowsSpeakOfTheirPair) {
  const Built b = build(pile(), kPilePairs);
  ASSERT_EQ(b.problem.contacts.size(), 2U);
  const ContactRow& disks = b.problem.contacts[0];
  EXPECT_EQ(disks.a, 0);
  EXPECT_EQ(disks.b, 1);
  EXPECT_LE(distance(disks.normal, Vec2(0, 1)), tolerance::rounding()) << "from a to b";
  EXPECT_EQ(disks.spin_a, Vec2(0, 2));
  EXPECT_EQ(disks.spin_b, Vec2(0, -1));
  EXPECT_EQ(disks.arm, 1.5);
  EXPECT_EQ(disks.friction, 0.3);
  EXPECT_NEAR(disks.rolling, 0.2 * 4.0 / 3, tolerance::rounding());
  EXPECT_NEAR(disks.gap_tolerance, 0.1 * 5e-5, tolerance::rounding());
  const ContactRow& floor = b.problem.contacts[1];
  EXPECT_EQ(floor.b, 2) << "walls follow the disks";
  EXPECT_LE(distance(floor.normal, Vec2(0, -1)), tolerance::rounding());
  EXPECT_EQ(floor.friction, 0.9);
  EXPECT_EQ(floor.rolling, 0) << "the wall's law has none";
}

TEST(ContactProblem, ABondPullsBothBodiesTogether) {
  const Built b = build(pile(), kPilePairs);
  const double dt = 1e-2;
  EXPECT_EQ(b.contacts[0].cohesion, 7);
  EXPECT_NEAR(b.problem.free_velocity[0].y(), -dt + 7 * dt / 16, tolerance::rounding());
  EXPECT_NEAR(b.problem.free_velocity[1].y(), -dt - 7 * dt / 8, tolerance::rounding());
}

TEST(ContactProblem, OnlyNamedTermsAreModelled) {
  Scenario scene = pile();
  EXPECT_EQ(build(scene, kPilePairs).problem.components, 3);
  scene.grain_law.rolling_friction.reset();
  EXPECT_EQ(build(scene, kPilePairs).problem.components, 2);
  scene.grain_law.friction.reset();
  scene.wall_law = ContactLaw{};
  EXPECT_EQ(build(scene, kPilePairs).problem.components, 1);
}

TEST(ContactProblem, TheCurvatureTermIsTheCentripetalGapOfATurningBond) {
  Scenario scene = spinning_pair(Method::automatic, 4, 100);
  const double dt = scene.step.dt;
  EXPECT_NEAR(build(scene, {{0, 1}}).problem.contacts[0].offset.x(), dt * 4 * 4 / 2,
              tolerance::rounding());
  scene.step.curvature_term = false;
  EXPECT_NEAR(build(scene, {{0, 1}}).problem.contacts[0].offset.x(), 0, tolerance::rounding());
}

// Within a step of 0.01, and foreseeing that a body may become twice as fast in it.
TEST(ContactProblem, PlainPairsThatCannotTouchWithinTheStepAreLeftOut) {
  Scenario scene = empty_scene(Method::automatic);
  scene.disks = {{.position = {0, 0}, .velocity = {0.9, 0}}, {.position = {1.02, 0}}};
  EXPECT_EQ(build(scene, {{0, 1}}).contacts.size(), 0U);
  scene.disks[0].velocity.x() = 1.1;
  EXPECT_EQ(build(scene, {{0, 1}}).contacts.size(), 1U);
}

TEST(ContactProblem, BodiesThatCannotMoveHaveNoContact) {
  Scenario scene = pile();
  scene.disks[0].fixed = true;
  const Built b = build(scene, kPilePairs);
  ASSERT_EQ(b.contacts.size(), 1U);
  EXPECT_EQ(b.contacts[0].pair, (Pair{0, 1}));
}

TEST(ContactProblem, WarmStartsAreByPairAndScaleWithTheStep) {
  World world = make_world(pile());
  world.impulse_dt = 1e-2;
  world.contacts = {{.pair = {0, 1}, .impulse = {0.5, 0.2, 0.1}, .cohesion = 7}};
  const std::vector<Contact> contacts = pile_contacts(world, 5e-3);
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_LE(distance(contacts[0].impulse, Vec3(0.25, 0.1, 0.05)), tolerance::rounding());
  EXPECT_EQ(distance(contacts[1].impulse, Vec3(0, 0, 0)), 0) << "a new contact";
}

// Friction that is not modelled any more must not act on.
TEST(ContactProblem, WarmStartsHaveOnlyWhatTheLawHas) {
  World world = make_world(pile());
  world.impulse_dt = 1e-2;
  world.contacts = {{.pair = {0, 1}, .impulse = {0.5, 0.2, 0.1}, .cohesion = 7}};
  world.grain_law.rolling_friction.reset();
  EXPECT_EQ(pile_contacts(world, 1e-2)[0].impulse, Vec3(0.5, 0.2, 0));
  world.grain_law.friction.reset();
  EXPECT_EQ(pile_contacts(world, 1e-2)[0].impulse, Vec3(0.5, 0, 0));
}

TEST(ContactProblem, ABondThatBrokeTakesItsPartOfTheImpulseAlong) {
  World world = make_world(pile());
  world.impulse_dt = 1e-2;
  world.contacts = {{.pair = {0, 1}, .impulse = {0.08, 0, 0}, .cohesion = 7}};
  world.bonds.list[0].state = BondState::broken;
  const std::vector<Contact> contacts = pile_contacts(world, 1e-2);
  EXPECT_EQ(contacts[0].cohesion, 0);
  EXPECT_NEAR(contacts[0].impulse.x(), 0.01, tolerance::rounding());
}

TEST(ContactProblem, MissedContactsAreThoseThatWouldOverlap) {
  Scenario scene = empty_scene(Method::automatic);
  scene.disks = {{.position = {0, 0}}, {.position = {1.5, 0}}, {.position = {0, 1.5}}};
  const World world = make_world(scene);
  std::vector<Vec3> velocity(3, Vec3(0, 0, 0));
  velocity[0].x() = 60;  // 0.6 in a step: into disk 1, past disk 2
  std::vector<Contact> contacts;
  const std::vector<Pair> all{{0, 1}, {0, 2}, {1, 2}};
  EXPECT_EQ(add_missed_contacts(world, all, velocity, 1e-2, 1e-7, contacts), 1);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].pair, (Pair{0, 1}));
  EXPECT_EQ(add_missed_contacts(world, all, velocity, 1e-2, 1e-7, contacts), 0) << "known now";
}

}  // namespace
}  // namespace quicksand
