#include "core/measures/regions.h"

#include <gtest/gtest.h>

#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/shapes/intruder_shapes.h"
#include "core/world/intruder_trajectory.h"
#include "core/world/shaped_contact.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

TEST(Regions, CountAContactByTheShareOfItsGrains) {
  World world = make_world(bonded_row(10));
  world.bonds.find({3, 4})->state = BondState::broken;  // still touching
  world.bonds.find({4, 5})->state = BondState::broken;
  const std::vector<int> region{0, 0, 0, 0, 0, 1, 1, 1, -1, -1};
  const std::vector<Region> regions = regions_of(world, touching_pairs(world), region, 2);
  // 0-1, 1-2, 2-3 and 3-4 lie inside, 4-5 by a half; 3-4 and 4-5 are broken.
  EXPECT_EQ(regions[0].grains, 5);
  EXPECT_EQ(regions[0].contacts, 4.5);
  EXPECT_EQ(regions[0].initial_bonds, 4.5);
  EXPECT_EQ(regions[0].coordination, 9 / 5.0);
  EXPECT_EQ(regions[0].active_bond_fraction, 3 / 4.5);
  EXPECT_EQ(regions[0].remaining_bond_fraction, 3 / 4.5);
  // 5-6, 6-7 inside, 4-5 (broken) and 7-8 by a half.
  EXPECT_EQ(regions[1].contacts, 3);
  EXPECT_EQ(regions[1].coordination, 2);
  EXPECT_EQ(regions[1].active_bond_fraction, 2.5 / 3);
}

TEST(Regions, ThatFillTheSampleAddUpToTheWhole) {
  Scenario scene = small_collapse(Method::automatic);
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() != Progress::finished) {
  }
  const World& world = protocol.world();
  const Sample whole = measure(world);
  std::vector<int> region;
  for (int i = 0; i < world.disks.size(); ++i) region.push_back(i % 3);
  double contacts = 0, active = 0, neighbours = 0, initial = 0, remaining = 0;
  std::int64_t grains = 0;
  for (const Region& r : regions_of(world, touching_pairs(world), region, 3)) {
    grains += r.grains;
    contacts += r.contacts;
    active += r.contacts * r.active_bond_fraction.value();
    neighbours += static_cast<double>(r.grains) * r.coordination.value();
    initial += r.initial_bonds;
    remaining += r.initial_bonds * r.remaining_bond_fraction.value();
  }
  EXPECT_EQ(grains, whole.grains);
  EXPECT_EQ(contacts, static_cast<double>(whole.contacts)) << "the intruder is not on the floor";
  EXPECT_NEAR(active, static_cast<double>(whole.bonds_active), tolerance::rounding(100));
  EXPECT_NEAR(neighbours, whole.coordination * static_cast<double>(grains),
              tolerance::rounding(100));
  EXPECT_EQ(initial, static_cast<double>(world.bonds.initial));
  EXPECT_NEAR(remaining, whole.remaining_bond_fraction.value() * initial, tolerance::rounding(100));
}

TEST(Regions, CountWallsAsNeighboursOfTheirGrain) {
  const World world = make_world(column(Method::automatic, 2));
  const Region both = regions_of(world, touching_pairs(world), std::vector<int>{0, 0}, 1)[0];
  EXPECT_EQ(both.contacts, 2);
  EXPECT_EQ(both.coordination, 1.5);
  EXPECT_FALSE(both.remaining_bond_fraction.has_value()) << "there are no bonds";
  const Region lower = regions_of(world, touching_pairs(world), std::vector<int>{0, -1}, 1)[0];
  EXPECT_EQ(lower.contacts, 1.5) << "the floor's whole, half of the upper one's";
}

// The row with an intruder of 2 d that went down at x = 4.5, and grains that fell into its channel.
World pierced_row() {
  World world = make_world(bonded_row(10));
  const int intruder =
      world.disks.add({.position = {4.5, -8}, .radius = 1, .role = DiskRole::intruder});
  for (double y = 8; y > -8; y -= 0.3) world.trajectory.places.push_back({4.5, y});
  world.disks.position[4].y() = -2;  // torn out, with both its bonds
  world.bonds.find({3, 4})->state = BondState::broken;
  world.bonds.find({4, 5})->state = BondState::broken;
  EXPECT_EQ(intruder, 10);
  return world;
}

TEST(Regions, OfAPiercedRowAreItsChannelAndItsEnds) {
  const AroundIntruder around = measure(pierced_row(), {.intact_distance = 1.4}).around_intruder;
  // Nearer than 1.5: the grain that was torn out and those beside its place, at 1 d.
  EXPECT_EQ(around.channel.grains, 3);
  EXPECT_EQ(around.channel.contacts, 1) << "half of 2-3, half of 5-6";
  EXPECT_EQ(around.channel.active_bond_fraction, 1);
  EXPECT_EQ(around.channel.initial_bonds, 3);
  EXPECT_EQ(around.channel.remaining_bond_fraction, 1 / 3.0);
  EXPECT_EQ(around.channel.coordination, 2 / 3.0);
  // Farther than 2.8: x = 0.5, 1.5 and 7.5 to 9.5.
  EXPECT_EQ(around.intact.grains, 5);
  EXPECT_EQ(around.intact.contacts, 4);
  EXPECT_EQ(around.intact.active_bond_fraction, 1);
  EXPECT_EQ(around.intact.remaining_bond_fraction, 1);
}

TEST(Regions, GrowAndShrinkWithTheChoices) {
  const World world = pierced_row();
  const auto grains = [&](const MeasureChoices& choices) {
    const AroundIntruder around = measure(world, choices).around_intruder;
    return std::pair(around.channel.grains, around.intact.grains);
  };
  EXPECT_EQ(grains({}), std::pair(std::int64_t{3}, std::int64_t{0})) << "none is 12 d away";
  EXPECT_EQ(grains({.channel_margin = 1.5, .intact_distance = 1.4}),
            std::pair(std::int64_t{5}, std::int64_t{5}));
  EXPECT_EQ(grains({.intact_distance = 1}), std::pair(std::int64_t{3}, std::int64_t{7}));
}

TEST(Regions, ByBondsAreTheGrainsThatKeptAllAndThoseThatLostOne) {
  World world = pierced_row();
  world.disks.add({.position = {20, 0}});  // never had a bond: kept none
  const auto [kept, lost] = by_bonds(world, touching_pairs(world));
  EXPECT_EQ(kept.grains, 7) << "all but 3, 4, 5";
  EXPECT_EQ(kept.remaining_bond_fraction, 1);
  EXPECT_EQ(kept.contacts, 6) << "2-3 and 5-6 by a half";
  EXPECT_EQ(lost.grains, 3);
  EXPECT_EQ(lost.contacts, 1) << "half of 2-3, half of 5-6";
  EXPECT_EQ(lost.remaining_bond_fraction, 1 / 3.0) << "of 2-3, 3-4, 4-5 and 5-6";
}

TEST(Regions, CountPairsUpToTheGapThatIsAskedFor) {
  World world = pierced_row();
  for (int i = 7; i < 10; ++i)
    world.disks.position[i].x() += 1e-3;  // opens 6-7, and keeps its bond
  const auto ends = [&](std::optional<double> gap) {
    const Sample s = measure(world, {.intact_distance = 1.4, .contact_gap = gap});
    return std::tuple(s.contacts, s.around_intruder.intact.contacts, s.active_bond_fraction);
  };
  EXPECT_EQ(ends({}), std::tuple(std::int64_t{6}, 3.5, 7 / 6.0))
      << "6-7 counts by a half, if it does";
  EXPECT_EQ(ends(2e-3), std::tuple(std::int64_t{7}, 4.0, 1.0));
}

TEST(Regions, AroundNoIntruderAreEmpty) {
  const AroundIntruder around = measure(make_world(bonded_row(10))).around_intruder;
  EXPECT_EQ(around.channel.grains + around.intact.grains, 0);
  EXPECT_FALSE(around.channel.coordination || around.intact.active_bond_fraction);
}

TEST(WeightAbove, IsThatOfTheColumnAndOfTheLevelOverAll) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = 20, .height = 20, .sides = Sides::periodic, .floor = true};
  // An intruder at the side; heavy, light, beside, below and between centre and top.
  scene.disks = {{.position = {0.5, 5}, .radius = 1.5, .density = 9, .role = DiskRole::intruder},
                 {.position = {19.5, 9}, .density = 3},
                 {.position = {0.5, 12}},
                 {.position = {5, 9}, .density = 2},
                 {.position = {0.5, 1}, .density = 3},
                 {.position = {3, 6}}};
  const World world = make_world(scene);
  const WeightAbove above = weight_above_intruder(world, {});
  EXPECT_EQ(above.column, (3 + 1) / 10.0);
  EXPECT_EQ(above.level, (3 + 1 + 2 + 1) / 10.0);
  EXPECT_EQ(weight_above_intruder(world, {.above_begins = 1}).level, (3 + 1 + 2) / 10.0)
      << "above its top only";
  EXPECT_EQ(weight_above_intruder(world, {.above_begins = -3}).level, 1);
  EXPECT_EQ(weight_above_intruder(make_world(column(Method::automatic, 2)), {}).level, 0);
}

// A plate stands upright: its top and lowest point are farther from its centre than its sides.
TEST(WeightAbove, ATallIntruderBeginsAtItsOwnTopAndLowestPoint) {
  Scenario scene = empty_scene(Method::automatic);
  scene.gravity = Vec2(0, -1);
  for (const double y : {2.0, 4.0, 6.0, 8.0}) scene.disks.push_back({.position = {9, y}});
  World world = make_world(scene);
  add_shape(world, {.position = {5, 5}},
            parts_of(PlateIntruder{.width = 5, .thickness = 0.5, .tilt = 90}));
  const auto level = [&](double begins) {
    return weight_above_intruder(world, {.above_begins = begins}).level;
  };
  EXPECT_EQ(level(0), 2 / 4.0);
  EXPECT_EQ(level(1), 1 / 4.0) << "6 is below its top at 7.5";
  EXPECT_EQ(level(-1), 3 / 4.0) << "4 is above its lowest point at 2.5";
}

}  // namespace
}  // namespace quicksand
