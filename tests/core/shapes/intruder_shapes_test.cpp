#include "core/shapes/intruder_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

double area_of(const IntruderShape& shape) { return mass_properties(parts_of(shape)).area; }

std::string problem_with(const IntruderShape& shape) { return problem_of(shape).key; }

TEST(IntruderShape, HasItsArea) {
  EXPECT_NEAR(area_of(DiskIntruder{.diameter = 2}), kHalfTurn, tolerance::rounding(10));
  EXPECT_NEAR(area_of(PlateIntruder{.width = 3, .thickness = 1, .tilt = 30}), 2 + kHalfTurn / 4,
              tolerance::rounding(10));
  // Four blades meet in a square of their thickness.
  const double reach = 3 - 0.2;
  EXPECT_NEAR(area_of(VaneIntruder{.blades = 4, .radius = 3, .thickness = 0.4}),
              4 * reach * 0.4 - 0.4 * 0.4 + 2 * kHalfTurn * 0.2 * 0.2, tolerance::rounding(10));
  // A triangle, a strip along its sides, and a disk in all at its corners.
  const double half = 1 - 0.1, height = half / std::tan(kHalfTurn / 6);
  const MassProperties cone = mass_properties(
      parts_of(ConeIntruder{.width = 2, .angle = 60, .length = 0, .rounding = 0.1}));
  EXPECT_NEAR(
      cone.area,
      half * height + 0.1 * (2 * half + 2 * half / std::sin(kHalfTurn / 6)) + kHalfTurn * 0.01,
      tolerance::rounding(10));
}

TEST(IntruderShape, ConeHasItsWidthAndAngle) {
  const std::vector<ConvexPart> parts =
      parts_of(ConeIntruder{.width = 3, .angle = 90, .length = 4, .rounding = 0.25});
  ASSERT_EQ(parts.size(), 2U);
  const std::vector<Vec2>& tip = parts[0].corners;
  EXPECT_NEAR(tip[1].x() + parts[0].radius, 1.5, tolerance::rounding());
  EXPECT_NEAR(std::abs(tip[0].y()), tip[1].x(), tolerance::rounding(10));  // 45 degrees
  EXPECT_TRUE(parts[1].shaft);
  EXPECT_FALSE(parts[0].shaft);
}

TEST(IntruderShape, IsConvexPartByPart) {
  for (const IntruderShape& shape :
       {IntruderShape{ConeIntruder{.length = 3}}, IntruderShape{PlateIntruder{.tilt = -40}},
        IntruderShape{BallOnRodIntruder{}}, IntruderShape{VaneIntruder{.blades = 5}}})
    for (const ConvexPart& part : parts_of(shape)) EXPECT_EQ(defect_of(part), nullptr);
}

TEST(IntruderShape, OfNothingIsRefused) {
  EXPECT_EQ(problem_with(ConeIntruder{}), "");
  EXPECT_EQ(problem_with(ConeIntruder{.width = 1, .rounding = 0.5}), "rounding");
  EXPECT_EQ(problem_with(PlateIntruder{.width = 1, .thickness = 1}), "thickness");
  EXPECT_EQ(problem_with(BallOnRodIntruder{.diameter = 1, .rod_width = 1}), "rod_width");
  EXPECT_EQ(problem_with(BallOnRodIntruder{.rod_width = 1, .rod_length = 0.5}), "rod_length");
  EXPECT_EQ(problem_with(VaneIntruder{.radius = 0.2, .thickness = 0.3}), "thickness");
  EXPECT_EQ(problem_with(PartsIntruder{}), "parts");
  EXPECT_EQ(problem_with(PartsIntruder{{{{{0, 0}}, 1}, {{{0, 0}, {0, 0}}, 1}}}), "parts[1]");
}

TEST(IntruderShape, ExtentIsThatOfTheCircleAboutItsCentre) {
  EXPECT_NEAR(largest_extent(PlateIntruder{.width = 3, .thickness = 1}), 3,
              tolerance::rounding(10));
  EXPECT_NEAR(largest_extent(DiskIntruder{.diameter = 2.5}), 2.5, tolerance::rounding(10));
}

}  // namespace
}  // namespace quicksand
