#include "core/measures/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/errors.h"
#include "core/measures/measures.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

// Bonded disks in rows, periodic to the sides; `shift` and `rise` between rows make the lattice.
World bonded_lattice(int columns, int rows, double shift, double rise) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = static_cast<double>(columns),
               .height = rows * rise,
               .sides = Sides::periodic,
               .floor = false};
  scene.grain_law = paper_law(10);
  scene.initial_bonds = InitialBonds::touching;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      scene.disks.push_back({.position = {x + shift * (y % 2), (y + 0.5) * rise}});
  return make_world(scene);
}

std::int64_t total(const Histogram& h) {
  return std::accumulate(h.counts.begin(), h.counts.end(), h.below + h.above);
}

// Count in the bin that holds the value.
std::int64_t count_at(const Histogram& h, double value) {
  std::size_t k = 0;
  while (k + 2 < h.edges.size() && h.edges[k + 1] <= value) ++k;
  return h.counts[k];
}

TEST(HistogramOf, ValuesPutsEachInItsBin) {
  const std::vector<double> values{-1, 0, 0.5, 0.99, 1, 2.5, 4, 4.1, 9};
  const Histogram h = histogram(values, even_edges(0, 4, 4));
  EXPECT_EQ(h.edges, (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(h.counts, (std::vector<std::int64_t>{3, 1, 1, 1}))
      << "the last edge is in the last bin";
  EXPECT_EQ(h.below, 1);
  EXPECT_EQ(h.above, 2);
  EXPECT_EQ(h.density()[0], 3 / 9.0);
}

TEST(HistogramOf, DensityIntegratesToOneOverBinsOfAnyWidth) {
  std::vector<double> values;
  for (int k = 1; k <= 1000; ++k) values.push_back(k);
  const Histogram h = histogram(values, decade_edges(0, 3, 5));
  ASSERT_EQ(h.counts.size(), 15U);
  const std::vector<double> density = h.density();
  double integral = 0;
  for (std::size_t k = 0; k < density.size(); ++k)
    integral += density[k] * (h.edges[k + 1] - h.edges[k]);
  EXPECT_NEAR(integral, 1, tolerance::rounding());
  EXPECT_EQ(histogram({}, even_edges(0, 1, 2)).density(), (std::vector<double>{0, 0}));
}

TEST(BondAngles, OfASquareLatticeAreRightAngles) {
  const World world = bonded_lattice(6, 6, 0, 1);
  // Inner disks have four; those of the first and last row two, and a straight one.
  const Histogram h = bond_angles(world);
  EXPECT_EQ(count_at(h, std::numbers::pi / 2), 4 * 24 + 2 * 12);
  EXPECT_EQ(h.counts.back(), 12);
  EXPECT_EQ(total(h), 4 * 24 + 3 * 12);
  const Histogram orientation = contact_orientations(world, touching_pairs(world));
  EXPECT_EQ(orientation.counts.front(), 6 * 6) << "horizontal";
  EXPECT_EQ(orientation.counts.back(), 6 * 5) << "vertical";
  EXPECT_EQ(total(orientation), 6 * 6 + 6 * 5);
}

TEST(BondAngles, OfATriangularLatticeAreSixtyDegrees) {
  const World world = bonded_lattice(6, 6, 0.5, std::sqrt(0.75));
  const Histogram h = bond_angles(world);
  EXPECT_EQ(count_at(h, std::numbers::pi / 3), 6 * 24 + 3 * 12);
  EXPECT_EQ(h.counts.back(), 12) << "straight, at the first and the last row";
  EXPECT_EQ(total(bond_angles(world, {0, 2, 3.2})), total(h)) << "in other bins, too";
  const Histogram orientation = contact_orientations(world, touching_pairs(world));
  EXPECT_EQ(orientation.counts.front(), 36);
  EXPECT_EQ(count_at(orientation, std::numbers::pi / 3), 2 * 6 * 5);
}

TEST(BondAngles, OfTwoBondsAreOneAngleWhicheverSideItOpens) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = paper_law(10);
  scene.initial_bonds = InitialBonds::touching;
  // The directions 170 and -110 degrees are 80 degrees apart, through pi.
  const auto at = [](double degrees) {
    return Vec2(std::cos(degrees * std::numbers::pi / 180),
                std::sin(degrees * std::numbers::pi / 180));
  };
  scene.disks = {{}, {.position = at(170)}, {.position = at(-110)}};
  World world = make_world(scene);
  EXPECT_EQ(total(bond_angles(world)), 1);
  EXPECT_EQ(count_at(bond_angles(world), 80 * std::numbers::pi / 180), 1);
  world.bonds.find({0, 1})->state = BondState::broken;
  EXPECT_EQ(total(bond_angles(world)), 0);
}

TEST(BondAngles, LeaveOutTheEmptyHalfPlane) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = paper_law(10);
  scene.initial_bonds = InitialBonds::touching;
  scene.disks = {
      {}, {.position = {1, 0}}, {.position = {0, 1}}, {.position = Vec2(-1, 1).normalized()}};
  // A fourth grain at 135 degrees overlaps that at 90: angles do not care.
  const Histogram h = bond_angles(make_world(scene));
  EXPECT_EQ(count_at(h, std::numbers::pi / 2), 1);
  EXPECT_EQ(count_at(h, std::numbers::pi / 4), 1);
  EXPECT_EQ(count_at(h, 3 * std::numbers::pi / 4), 0);
}

TEST(ContactForces, OfAColumnAreTheWeightsAbove) {
  Simulation run(column(Method::automatic, 8));
  EXPECT_EQ(total(contact_forces(run.world)), 0) << "before any step";
  run.advance(3);
  // 1 to 8 weights over their mean of 4.5, in bins of a tenth of a decade: 6 and 7 share one.
  const Histogram h = contact_forces(run.world);
  EXPECT_EQ(total(h), 8);
  for (const int weight : {1, 2, 3, 4, 5, 8}) EXPECT_EQ(count_at(h, weight / 4.5), 1) << weight;
  for (const int weight : {6, 7}) EXPECT_EQ(count_at(h, weight / 4.5), 2) << weight;
  EXPECT_EQ(total(bond_tensions(run.world)), 0);
}

TEST(ContactForces, LeaveOutTheIntruder) {
  Scenario scene = column(Method::automatic, 2);
  scene.disks.push_back({.position = {0, 3.5}, .radius = 1.5, .role = DiskRole::intruder});
  scene.disk_forces = {{0, 0, 0}, {0, 0, 0}, {0, -1000, 0}};
  Simulation run(scene);
  run.advance(3);
  EXPECT_EQ(total(contact_forces(run.world)), 2) << "grain on grain, grain on floor";
}

TEST(BondTensions, OfAHangingChainAreTheWeightsBelowOverTheCohesionForce) {
  Simulation run(hanging_chain(Method::automatic, 3, 100));
  run.advance(3);
  const Histogram h = bond_tensions(run.world);
  EXPECT_EQ(total(h), 3);
  for (const double tension : {0.0201, 0.0301}) EXPECT_EQ(count_at(h, tension), 1) << tension;
  EXPECT_EQ(total(contact_forces(run.world)), 0);
}

TEST(BondTensions, DoNotCountABondThatJustBroke) {
  Simulation run(pulled_pair(Method::automatic, 20, 10));
  while (run.bonds_broken == 0 && run.world.step < 1000) run.advance();
  ASSERT_EQ(run.bonds_broken, 1);
  EXPECT_EQ(total(bond_tensions(run.world)), 0);
}

TEST(HeightProfile, OfASquareLatticeIsTheSameInEverySlice) {
  World world = bonded_lattice(6, 6, 0, 1);
  world.box.floor = true;  // from y = 0, also where rounding puts a grain below
  world.bonds.find({0, 1})->state = BondState::broken;
  const std::vector<Slice> slices = height_profile(world, touching_pairs(world), 2);
  ASSERT_EQ(slices.size(), 3U);
  for (const Slice& slice : slices) {
    EXPECT_NEAR(slice.volume_fraction.value(), std::numbers::pi / 4, tolerance::rounding());
    EXPECT_EQ(slice.grains.grains, 12);
  }
  EXPECT_EQ(slices[0].low, 0);
  EXPECT_EQ(slices[2].high, 6);
  EXPECT_EQ(slices[0].grains.coordination, 3.5);
  EXPECT_EQ(slices[1].grains.coordination, 4);
  EXPECT_EQ(slices[0].grains.contacts, 12 + 6 + 3)
      << "two rows, between them, and half to the next";
  EXPECT_EQ(slices[0].grains.active_bond_fraction, 20 / 21.0);
  EXPECT_EQ(slices[1].grains.active_bond_fraction, 1);
}

TEST(HeightProfile, BeginsAtTheLowestGrainOrAtTheFloor) {
  Scenario scene = empty_scene(Method::automatic);
  scene.disks = {{.position = {0, -3.2}}, {.position = {0, 3.2}}};
  const World world = make_world(scene);
  const std::vector<Slice> slices = height_profile(world, touching_pairs(world), 2);
  ASSERT_EQ(slices.size(), 4U);
  EXPECT_EQ(slices.front().low, -3.7);
  EXPECT_EQ(slices.front().high, -2);
  EXPECT_EQ(slices.back().high, 4);
  EXPECT_EQ(slices.front().grains.grains, 1);
  EXPECT_FALSE(slices.front().volume_fraction.has_value()) << "the box has no width";
  EXPECT_THROW(height_profile(world, touching_pairs(world), 1e-5), InputError);
  EXPECT_TRUE(height_profile(make_world(empty_scene(Method::automatic)), {}, 1).empty());
}

TEST(FabricOf, AnUprightColumnHasOneDirection) {
  const World world = make_world(column(Method::automatic, 5));
  const Fabric fabric = fabric_of(world, touching_pairs(world)).value();
  EXPECT_NEAR(fabric.anisotropy, 1, tolerance::rounding());
  EXPECT_NEAR(fabric.direction, std::numbers::pi / 2, tolerance::rounding());
}

TEST(FabricOf, TrianglesAndSquaresHaveNoDirection) {
  const double h = std::numbers::sqrt3 / 2;
  for (const std::vector<Vec2>& corners : {std::vector<Vec2>{{0, 0}, {1, 0}, {0.5, h}},
                                           std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) {
    Scenario scene = empty_scene(Method::automatic);
    for (const Vec2& corner : corners) scene.disks.push_back({.position = corner});
    const World world = make_world(scene);
    EXPECT_NEAR(fabric_of(world, touching_pairs(world)).value().anisotropy, 0,
                tolerance::rounding());
  }
}

TEST(FabricOf, NoContactsHaveNoFabric) {
  EXPECT_FALSE(fabric_of(make_world(empty_scene(Method::automatic)), {}));
}

TEST(ProfileOf, StressGrowsWithTheWeightAbove) {
  Scenario scene = column(Method::automatic, 20);
  scene.box.sides = Sides::periodic;
  scene.box.width = 2;
  Simulation run(scene);
  run.advance(3);
  const std::vector<Slice> slices = height_profile(run.world, touching_pairs(run.world), 5);
  ASSERT_EQ(slices.size(), 4U);
  for (const Slice& slice : slices)
    EXPECT_NEAR(slice.stress.value().yy, (20 - (slice.low + slice.high) / 2) / 2,
                tolerance::solved(20))
        << slice.low;
}

}  // namespace
}  // namespace quicksand
