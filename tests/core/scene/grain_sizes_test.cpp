#include "core/scene/grain_sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"
#include "core/world/extent.h"
#include "core/world/neighbors.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

struct Moments {
  double mean = 0, deviation = 0;
};

Moments moments(const std::vector<double>& values) {
  Moments m;
  const auto n = static_cast<double>(values.size());
  for (const double x : values) m.mean += x / n;
  for (const double x : values) m.deviation += (x - m.mean) * (x - m.mean) / n;
  m.deviation = std::sqrt(m.deviation);
  return m;
}

TEST(GrainSizes, HaveMeanOneAndTheGivenDeviationInSpiteOfTheCut) {
  constexpr int kDraws = 100000;
  for (const double deviation : {0.01, 0.2, 0.35, kMostDeviation}) {
    Random random{7};
    std::vector<double> diameters(kDraws);
    const double before_cut = deviation_before_cut(deviation);
    for (double& d : diameters) d = draw_diameter(random, before_cut);
    const Moments m = moments(diameters);
    const double four_sigma = 4 * deviation / std::sqrt(kDraws);
    EXPECT_NEAR(m.mean, 1, tolerance::sampled(four_sigma)) << deviation;
    EXPECT_NEAR(m.deviation, deviation, tolerance::sampled(four_sigma)) << deviation;
    EXPECT_GE(std::ranges::min(diameters), kLeastDiameter);
    EXPECT_LE(std::ranges::max(diameters), kMostDiameter);
  }
}

TEST(GrainSizes, AreNormalWhereTheCutIsFarAway) {
  EXPECT_NEAR(deviation_before_cut(0.05), 0.05, tolerance::exact());
  Random random{3};
  constexpr int kDraws = 100000;
  int within = 0;
  for (int k = 0; k < kDraws; ++k) within += std::abs(draw_diameter(random, 0.05) - 1) < 0.05;
  EXPECT_NEAR(within / double(kDraws), std::erf(std::sqrt(0.5)), tolerance::sampled(0.006));
}

QUICKSAND_PER_SOLVER(DepositOfSizes);

World deposited(Scenario scene, const DepositPhase& deposit) {
  scene.phases = {{deposit}};
  Protocol protocol(scene, make_world(scene));
  while (protocol.advance() != Progress::finished) {
  }
  return protocol.world();
}

Scenario box(Sides sides, double width) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = width, .height = 100, .sides = sides, .floor = true};
  scene.gravity = Vec2(0, -1);
  scene.grain_law = paper_law(1e4);
  return scene;
}

std::vector<double> diameters(const World& world) {
  std::vector<double> d = world.disks.radius;
  for (double& x : d) x *= 2;
  return d;
}

double deepest_overlap(const World& world) {
  double deepest = 0;
  for (const Pair& pair : pairs_within(world, 0)) deepest = std::max(deepest, -world.gap(pair));
  return deepest;
}

constexpr DepositPhase kSizes{
    .grains = 3000, .interval = 0, .polydispersity = Polydispersity{.deviation = 0.35}};

TEST(Deposit, OfManySizesHasTheirMomentsAndNoOverlaps) {
  for (const Sides sides : {Sides::periodic, Sides::walls}) {
    const World world = deposited(box(sides, 60), kSizes);
    const Moments m = moments(diameters(world));
    EXPECT_NEAR(m.mean, 1, tolerance::sampled(0.03));
    EXPECT_NEAR(m.deviation, 0.35, tolerance::sampled(0.02));
    EXPECT_LE(deepest_overlap(world), tolerance::rounding(100));
    EXPECT_EQ(world.bonds.formed, 3000);
    for (int i = 0; i < world.disks.size(); ++i)
      EXPECT_NEAR(world.disks.mass[i], std::pow(2 * world.disks.radius[i], 2),
                  tolerance::rounding());
  }
}

TEST(Deposit, OfManySizesEndsBelowItsHeight) {
  DepositPhase sizes = kSizes;
  sizes.grains = 0;
  sizes.height = 12;
  const World world = deposited(box(Sides::periodic, 20), sizes);
  EXPECT_LE(packing_top(world), 12);
  EXPECT_GT(packing_top(world), 11);
}

TEST_P(DepositOfSizes, HoldsTogetherWhileItGrows) {
  Scenario scene = box(Sides::periodic, 8);
  scene.solver.method = GetParam();
  scene.solver.tolerance = 1e-6;
  DepositPhase sizes = kSizes;
  sizes.grains = 30;
  sizes.interval = 0.02;
  const World world = deposited(scene, sizes);
  EXPECT_EQ(world.disks.size(), 30);
  EXPECT_EQ(world.bonds.broken, 0);
  EXPECT_LE(deepest_overlap(world), tolerance::sampled(1e-4));
}

TEST(Deposit, WithALargerCaptureRadiusIsLooserAndHasNoOverlaps) {
  double denser = 1;
  for (const double capture : {0.0, 0.1, 0.5, 1.0}) {
    for (const bool sizes : {false, true}) {
      DepositPhase deposit{.grains = 6000, .interval = 0, .capture_radius = capture};
      if (sizes) deposit.polydispersity = kSizes.polydispersity;
      const World world = deposited(box(Sides::walls, 100), deposit);
      EXPECT_LE(deepest_overlap(world), tolerance::rounding(100)) << capture;
      EXPECT_EQ(world.bonds.formed, 6000);
      for (const Bond& bond : world.bonds.list)
        ASSERT_NEAR(world.gap(bond.pair), 0, tolerance::rounding(100)) << "it is placed in touch";
      if (sizes) continue;
      const double top = packing_top(world);
      const double volume = volume_fraction(world, 0.3 * top, 0.7 * top);
      EXPECT_LT(volume, 0.97 * denser) << capture;
      denser = volume;
    }
  }
}

TEST(Validation, RefusesABoxTooNarrowForTheLargestGrain) {
  Scenario scene = box(Sides::periodic, 5);
  scene.phases = {{kSizes}};
  EXPECT_THROW(validate(scene), InputError);
  scene.box.width = 3 * kMostDiameter;
  EXPECT_NO_THROW(validate(scene));
}

}  // namespace
}  // namespace quicksand
