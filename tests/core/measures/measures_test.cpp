#include "core/measures/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/shapes/intruder_shapes.h"
#include "core/world/extent.h"
#include "core/world/shaped_contact.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

// Rows of touching disks in a periodic box; `shift` and `rise` between rows make the lattice.
Scenario lattice(int columns, int rows, double shift, double rise) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = static_cast<double>(columns),
               .height = rows * rise,
               .sides = Sides::periodic,
               .floor = false};
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      scene.disks.push_back({.position = {x + shift * (y % 2), (y + 0.5) * rise}});
  return scene;
}

const double kTriangularRise = std::sqrt(0.75);

TEST(ContactCounts, AWiderGapCountsMoreNeighboursAndASmallerShareOfBonds) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = paper_law(10);
  scene.initial_bonds = InitialBonds::touching;
  for (const double x : {0.0, 1.0, 2.0005, 3.005, 9.0}) scene.disks.push_back({.position = {x, 0}});
  const Sample sample = measure(make_world(scene));
  EXPECT_DOUBLE_EQ(sample.coordination, 2.0 / 5);
  EXPECT_DOUBLE_EQ(sample.within[0].coordination, 4.0 / 5);
  EXPECT_DOUBLE_EQ(sample.within[1].coordination, 6.0 / 5);
  EXPECT_DOUBLE_EQ(*sample.active_bond_fraction, 1);
  EXPECT_DOUBLE_EQ(*sample.within[0].active_bond_fraction, 1.0 / 2);
  EXPECT_DOUBLE_EQ(*sample.within[1].active_bond_fraction, 1.0 / 3);
}

// Bonds that reach farther than the margin do not count within it.
TEST(ContactCounts, NoMarginHoldsMoreActiveBondsThanPairs) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = paper_law(10);
  scene.grain_law.cohesion_range = 0.1;
  scene.initial_bonds = InitialBonds::touching;
  for (const double x : {0.0, 1.0, 2.05}) scene.disks.push_back({.position = {x, 0}});
  const Sample sample = measure(make_world(scene));
  EXPECT_EQ(sample.bonds_active, 2);
  EXPECT_EQ(*sample.within[0].active_bond_fraction, 1);
  EXPECT_EQ(*sample.within[1].active_bond_fraction, 1);
}

// Four in a row, their bonds active, torn and torn, and one alone; the last pair is not compressed.
TEST(ContactCounts, TellTouchingFromLoadedAndBonded) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = paper_law(10);
  scene.initial_bonds = InitialBonds::touching;
  for (const double x : {0.5, 1.5, 2.5, 3.5, 9.0}) scene.disks.push_back({.position = {x, 0}});
  World world = make_world(scene);
  for (const int a : {1, 2}) world.bonds.find({a, a + 1})->state = BondState::broken;
  world.contacts = {{.pair = {0, 1}}, {.pair = {1, 2}, .impulse = {1, 0, 0}}, {.pair = {2, 3}}};
  const ContactCounts counts = contact_counts(world, count_neighbours(world));
  EXPECT_DOUBLE_EQ(counts.touching, 6 / 5.0);
  EXPECT_DOUBLE_EQ(counts.loaded, 4 / 5.0);
  EXPECT_DOUBLE_EQ(counts.bonded, 2 / 5.0);
  EXPECT_DOUBLE_EQ(counts.without, 1 / 5.0);
  EXPECT_EQ(contact_counts(World{}, {}).touching, 0) << "no grains, no mean";
}

TEST(VolumeFraction, OfASquareLatticeIsAQuarterOfPi) {
  const World world = make_world(lattice(6, 6, 0, 1));
  EXPECT_NEAR(volume_fraction(world, 0, 6), std::numbers::pi / 4, tolerance::rounding());
  EXPECT_NEAR(volume_fraction(world, 1, 3), std::numbers::pi / 4, tolerance::rounding());
  EXPECT_NEAR(volume_fraction(world, 1.5, 3.5), std::numbers::pi / 4, tolerance::rounding());
}

// The area below a tilted wall is neither filled nor void.
TEST(VolumeFraction, IsUndefinedAboveATiltedWall) {
  World world = make_world(lattice(6, 6, 0, 1));
  EXPECT_TRUE(measure(world).volume_fraction.has_value());
  world.walls.push_back({.point = {0, 0}, .normal = Vec2(1, 1).normalized()});
  EXPECT_FALSE(measure(world).volume_fraction.has_value());
}

TEST(VolumeFraction, OfATriangularLatticeIsTheDensestOne) {
  const World world = make_world(lattice(6, 12, 0.5, kTriangularRise));
  const double low = 3 * kTriangularRise, high = 9 * kTriangularRise;
  EXPECT_NEAR(volume_fraction(world, low, high), std::numbers::pi / std::sqrt(12),
              tolerance::rounding());
}

TEST(VolumeFraction, CutsDisksExactly) {
  World world = make_world(lattice(4, 1, 0, 1));
  const double h = 0.2;  // segment of height h of four disks of radius 1/2
  const double segment = 0.25 * std::acos(1 - h / 0.5) - (0.5 - h) * std::sqrt(h - h * h);
  EXPECT_NEAR(volume_fraction(world, 0, h), 4 * segment / (4 * h), tolerance::rounding());
  EXPECT_NEAR(volume_fraction(world, 0, 0.5), std::numbers::pi / 4, tolerance::rounding());
  EXPECT_EQ(volume_fraction(world, 2, 3), 0);
  EXPECT_EQ(volume_fraction(world, 1, 1), 0) << "an empty slice";
}

TEST(VolumeFraction, CutsShapedBodiesExactly) {
  World world;
  world.box = {.width = 20, .height = 20, .sides = Sides::periodic, .floor = true};
  const int body = add_shape(world, {.position = {10, 10}},
                             parts_of(PlateIntruder{.width = 6, .thickness = 2, .tilt = 0}));
  // Upright: between its round ends it is 2 d wide.
  world.disks.angle[body] = std::numbers::pi / 2;
  EXPECT_NEAR(volume_fraction(world, 8, 12), 2 / 20.0, tolerance::rounding());
  EXPECT_NEAR(volume_fraction(world, 12, 13) * 20, std::numbers::pi / 2, tolerance::rounding(10));
  EXPECT_NEAR(volume_fraction(world, 10, 14) * 80, 4 + std::numbers::pi / 2,
              tolerance::rounding(10));
  EXPECT_NEAR(volume_fraction(world, 13.5, 20), 0, tolerance::rounding());
}

TEST(VolumeFraction, OfSlicesThroughAShapedBodyAddsUpToItsArea) {
  const std::vector<ConvexPart> vane =
      parts_of(VaneIntruder{.blades = 5, .radius = 3, .thickness = 0.4});
  World world;
  world.box = {.width = 20, .height = 20, .sides = Sides::periodic, .floor = true};
  const int body = add_shape(world, {.position = {10, 10}}, vane);
  world.disks.angle[body] = 0.37;
  double area = 0;
  for (int k = 0; k < 37; ++k)
    area += volume_fraction(world, 20.0 * k / 37, 20.0 * (k + 1) / 37) * 20 * 20 / 37;
  EXPECT_NEAR(area, mass_properties(vane).area, tolerance::rounding(100));
}

TEST(VolumeFraction, OfAPackingDoesNotDependOnWhereItsFloorIs) {
  for (const bool on_floor : {true, false}) {
    Scenario scene = lattice(6, 10, 0, 1);
    for (Disk& disk : scene.disks) disk.position.y() += 20;
    if (on_floor) scene.walls = {{.point = {0, 20}}};
    EXPECT_NEAR(measure(make_world(scene)).volume_fraction.value(), std::numbers::pi / 4,
                tolerance::rounding(10));
  }
}

TEST(VolumeFraction, OfSlicesAddsUpToTheTotal) {
  const World world = make_world(falling_cluster(Method::automatic, 30, 3, {}));
  World boxed = world;
  boxed.box.width = 8;
  for (int bins : {1, 7, 64}) {
    double sum = 0;
    for (int k = 0; k < bins; ++k)
      sum += volume_fraction(boxed, 9.0 * k / bins, 9.0 * (k + 1) / bins);
    EXPECT_NEAR(sum / bins, volume_fraction(boxed, 0, 9), tolerance::rounding());
  }
  double area = 0;
  for (double r : boxed.disks.radius) area += std::numbers::pi * r * r;
  EXPECT_NEAR(volume_fraction(boxed, -10, 20) * 8 * 30, area, tolerance::rounding(100));
}

TEST(Coordination, OfTheTwoLattices) {
  // Inner disks have 4 and 6 neighbours, those of the first and last row 3 and 4.
  const Sample square = measure(make_world(lattice(6, 6, 0, 1)));
  EXPECT_NEAR(square.coordination, (4 * 4 + 2 * 3) / 6.0, tolerance::rounding());
  EXPECT_EQ(square.contacts, 6 * 6 + 6 * 5);
  const Sample triangular = measure(make_world(lattice(6, 8, 0.5, kTriangularRise)));
  EXPECT_NEAR(triangular.coordination, (6 * 6 + 2 * 4) / 8.0, tolerance::rounding());
}

// Two fixed grains on the floor and one on both: of five pairs that touch, two can bond and carry.
TEST(Coordination, LeavesOutPairsOfImmovableBodies) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = 10, .height = 5, .sides = Sides::open, .floor = true};
  scene.grain_law = paper_law(10);
  scene.initial_bonds = InitialBonds::touching;
  scene.disks = {{.position = {4, 0.5}, .fixed = true},
                 {.position = {5, 0.5}, .fixed = true},
                 {.position = {4.5, 0.5 + kTriangularRise}}};
  const World world = make_world(scene);
  EXPECT_EQ(touching_pairs(world), (std::vector<Pair>{{0, 2}, {1, 2}}));
  const Sample sample = measure(world);
  EXPECT_EQ(sample.contacts, 2);
  EXPECT_DOUBLE_EQ(sample.coordination, 4 / 3.0);
  EXPECT_DOUBLE_EQ(sample.active_bond_fraction.value(), 1);
  World overlapping = world;
  overlapping.disks.position[1].x() -= 0.1;
  EXPECT_NEAR(measure(overlapping).max_overlap, 0.1, tolerance::rounding());
}

TEST(Coordination, CountsWallsAsNeighboursAndIntrudersNotAsGrains) {
  Scenario scene = column(Method::automatic, 2);
  scene.disks.push_back({.position = {0, 3.5}, .radius = 1.5, .role = DiskRole::intruder});
  const Sample sample = measure(make_world(scene));
  EXPECT_EQ(sample.grains, 2);
  EXPECT_EQ(sample.coordination, 2);
  EXPECT_EQ(sample.packing_top, 2);
  EXPECT_TRUE(sample.has_intruder);
  EXPECT_EQ(sample.intruder_position, Vec2(0, 3.5));
}

// At rest the contacts carry its weight and what pushes it, whether bonds pull or not.
TEST(Resistance, OfAnIntruderAtRestIsItsWeightAndThePush) {
  for (const ContactLaw& law : {ContactLaw{}, paper_law(10)}) {
    Scenario scene = column(Method::automatic, 2, law);
    scene.disks.push_back(
        {.position = {0, 3.5}, .radius = 1.5, .density = 0.5, .role = DiskRole::intruder});
    scene.disk_forces = {{0, 0, 0}, {0, 0, 0}, {0, -7, 0}};
    scene.initial_bonds = InitialBonds::touching;
    Simulation run(scene);
    EXPECT_EQ(measure(run.world).resistance, 0) << "no step yet";
    run.advance(3);
    EXPECT_NEAR(measure(run.world).resistance, 0.5 * 9 + 7, tolerance::solved(10));
  }
}

TEST(BondFractions, FollowTheBonds) {
  Scenario scene = column(Method::automatic, 4, paper_law(10));
  scene.initial_bonds = InitialBonds::touching;
  World world = make_world(scene);
  EXPECT_EQ(measure(world).active_bond_fraction, 1);
  EXPECT_EQ(measure(world).remaining_bond_fraction, 1);
  world.bonds.find({1, 2})->state = BondState::broken;
  EXPECT_EQ(measure(world).active_bond_fraction, 0.75);
  EXPECT_EQ(measure(world).remaining_bond_fraction, 0.75);
  const NeighbourCounts n = count_neighbours(world);
  EXPECT_EQ(n.active, (std::vector<int>{2, 1, 1, 1}));
  EXPECT_EQ(n.broken, (std::vector<int>{0, 1, 1, 0}));
  EXPECT_EQ(n.initial, (std::vector<int>{2, 2, 2, 1}));
  EXPECT_EQ(n.initial_active, (std::vector<int>{2, 1, 1, 1}));
  EXPECT_EQ(n.touching, (std::vector<int>{2, 2, 2, 1}));
}

TEST(Energies, AreTheTextbookOnes) {
  Scenario scene = empty_scene(Method::automatic);
  scene.gravity = Vec2(0, -1);
  scene.disks = {{.position = {0, 5}, .radius = 1, .velocity = {3, 4}, .spin = 2},
                 {.position = {0, 9}, .velocity = {9, 9}, .fixed = true}};
  const Energies e = energies(make_world(scene));
  EXPECT_EQ(e.kinetic, 4 * 25 / 2.0);
  EXPECT_EQ(e.rotational, 2 * 4 / 2.0);
  EXPECT_EQ(e.potential, 4 * 5);
}

TEST(LoadedNeighbours, CountActiveBondsBeforeAnyStep) {
  Scenario scene = column(Method::automatic, 3, paper_law(10));
  scene.initial_bonds = InitialBonds::touching;
  const World world = make_world(scene);
  ASSERT_TRUE(world.contacts.empty());
  EXPECT_EQ(count_neighbours(world).loaded, (std::vector<int>{2, 2, 1}));
}

// The contacts are of the last step, but a bond that broke in it holds no more.
TEST(LoadedNeighbours, DoNotCountABondThatJustBroke) {
  Simulation run(pulled_pair(Method::automatic, 20, 10));
  while (run.bonds_broken == 0 && run.world.step < 1000) run.advance();
  ASSERT_EQ(run.bonds_broken, 1);
  EXPECT_EQ(count_neighbours(run.world).loaded, (std::vector<int>{0, 0}));
}

TEST(PackingTop, MayBeBelowZero) {
  World world;
  world.disks.add({.position = {0, -20}});
  world.disks.add({.position = {3, -18}});
  EXPECT_EQ(packing_top(world), -17.5);
}

TEST(Measures, OfAnEmptyWorldAreZeroOrAbsent) {
  const Sample sample = measure(make_world(empty_scene(Method::automatic)));
  EXPECT_EQ(sample.grains, 0);
  EXPECT_EQ(sample.coordination, 0);
  EXPECT_FALSE(sample.volume_fraction.has_value()) << "its sides are open";
  EXPECT_FALSE(sample.active_bond_fraction.has_value()) << "there are no contacts";
  EXPECT_FALSE(sample.remaining_bond_fraction.has_value()) << "there are no bonds";
}

}  // namespace
}  // namespace quicksand
