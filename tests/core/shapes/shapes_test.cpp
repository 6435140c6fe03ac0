#include "core/shapes/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_mass_properties(const std::vector<ConvexPart>& parts, double area, const Vec2& centre,
                            double second_moment) {
  const MassProperties found = mass_properties(parts);
  EXPECT_NEAR(found.area, area, tolerance::rounding(area));
  EXPECT_LE(distance(found.centre, centre), tolerance::rounding(1 + centre.norm()));
  EXPECT_NEAR(found.second_moment, second_moment, tolerance::rounding(second_moment));
}

TEST(Shapes, DiskHasTheMomentOfADisk) {
  expect_mass_properties({{{{3, -2}}, 1.5}}, kPi * 2.25, {3, -2}, kPi * std::pow(1.5, 4) / 2);
}

TEST(Shapes, OverlappingDisksCountTheirLensOnce) {
  // The lens is two circular segments of half-angle alpha.
  const double r = 1.3, apart = 1.1, alpha = std::acos(apart / 2 / r);
  const double s = std::sin(alpha), c = std::cos(alpha);
  const double segment = r * r * (alpha - s * c);
  const double first = 2 * r * r * r * s * s * s / 3;  // about the circle's centre
  const double about_circle = std::pow(r, 4) / 2 * (alpha - s * c + 2.0 / 3 * s * s * s * c);
  const double h = apart / 2;
  const double lens = 2 * (about_circle - 2 * h * first + segment * h * h);
  const double disk = kPi * r * r;
  expect_mass_properties({{{{2, 1}}, r}, {{{2 + apart, 1}}, r}}, 2 * disk - 2 * segment, {2 + h, 1},
                         2 * (disk * r * r / 2 + disk * h * h) - lens);
}

TEST(Shapes, CapsuleHasTheAreaAndMomentOfItsRectangleAndCaps) {
  const double l = 2.5, r = 0.4;
  const double moment = 2 * r * l * (l * l + 4 * r * r) / 12 + kPi * std::pow(r, 4) / 2 +
                        kPi * r * r * l * l / 4 + 4 * l * r * r * r / 3;
  // Along a direction of its own.
  const Vec2 along(0.6, 0.8), middle(-3, 7);
  expect_mass_properties({{{middle - l / 2 * along, middle + l / 2 * along}, r}},
                         2 * r * l + kPi * r * r, middle, moment);
}

// Area and moment of a rectangle a b whose corners are rounded by r beyond it.
MassProperties rounded_rectangle(double a, double b, double r) {
  const auto strip = [&](double length, double across) {
    return 2 * (length * r * (length * length + r * r) / 12 +
                length * r * std::pow(across / 2 + r / 2, 2));
  };
  return {.area = a * b + 2 * (a + b) * r + kPi * r * r,
          .second_moment = a * b * (a * a + b * b) / 12 + strip(a, b) + strip(b, a) +
                           kPi * r * r * (a * a + b * b) / 4 + 4 * (a + b) * r * r * r / 3 +
                           kPi * std::pow(r, 4) / 2};
}

TEST(Shapes, PolygonIsFilled) {
  const double a = 3, b = 1.5, r = 0.2;
  const MassProperties whole = rounded_rectangle(a, b, r);
  expect_mass_properties({{{{0, 0}, {a, 0}, {a, b}, {0, b}}, r}}, whole.area, {a / 2, b / 2},
                         whole.second_moment);
}

TEST(Shapes, PartsThatLieOnEachOtherCountOnce) {
  const double a = 3, b = 1.5, r = 0.2;
  const MassProperties whole = rounded_rectangle(a, b, r);
  const ConvexPart part{{{0, 0}, {a, 0}, {a, b}, {0, b}}, r};
  expect_mass_properties({part, part}, whole.area, {a / 2, b / 2}, whole.second_moment);
  // The same rectangle as two that share an edge, and each corner as a disk.
  const ConvexPart left{{{0, 0}, {a / 3, 0}, {a / 3, b}, {0, b}}, r};
  const ConvexPart right{{{a / 3, 0}, {a, 0}, {a, b}, {a / 3, b}}, r};
  expect_mass_properties({left, right, {{{0, 0}}, r}, {{{a, b}}, r}}, whole.area, {a / 2, b / 2},
                         whole.second_moment);
  // A bent line of capsules that share their caps.
  const double l = 2, cap = 0.3;
  const double straight = 2 * cap * l + kPi * cap * cap;
  const MassProperties bent = mass_properties(
      std::vector<ConvexPart>{{{{0, 0}, {l, 0}}, cap}, {{{l, 0}, {2 * l, 0}}, cap}});
  EXPECT_NEAR(bent.area, straight + 2 * cap * l, tolerance::rounding(straight));
}

TEST(Shapes, MassPropertiesDoNotDependOnThePlaceOfTheOrigin) {
  std::vector<ConvexPart> parts{
      {{{0, 0}, {4, 0}}, 0.3}, {{{1, -1}, {2, 3}, {0, 2}}, 0.1}, {{{4, 1}}, 1}};
  const MassProperties near = mass_properties(parts);
  const Vec2 shift(1000, -500);
  for (ConvexPart& part : parts)
    for (Vec2& corner : part.corners) corner += shift;
  const MassProperties far = mass_properties(parts);
  EXPECT_NEAR(far.area, near.area, tolerance::rounding(1e3));
  EXPECT_LE(distance(far.centre, Vec2(near.centre + shift)), tolerance::rounding(1e3));
  EXPECT_NEAR(far.second_moment, near.second_moment, tolerance::rounding(1e3));
}

TEST(Shapes, ManyPartsOfAFoot) {
  // A row of 200 disks that overlap: each adds the same.
  std::vector<ConvexPart> parts;
  parts.reserve(200);
  for (int k = 0; k < 200; ++k) parts.push_back({{{0.5 * k, 0}}, 0.5});
  const double lens = 2 * 0.25 * std::acos(0.5) - 0.25 * std::sqrt(0.75);
  EXPECT_NEAR(mass_properties(parts).area, 200 * kPi / 4 - 199 * lens, tolerance::rounding(200));
}

TEST(NearestPoint, OfACornerIsADisks) {
  const std::vector<Vec2> corner{{3, 4}};
  const NearestPoint nearest = nearest_to_origin(corner);
  EXPECT_EQ(nearest.distance, 5);
  EXPECT_LE(distance(nearest.normal, Vec2(0.6, 0.8)), tolerance::rounding());
  EXPECT_FALSE(nearest.flank);
}

TEST(NearestPoint, OfAnEdgeIsBesideIt) {
  const std::vector<Vec2> edge{{-2, 1}, {5, 1}};
  const NearestPoint nearest = nearest_to_origin(edge);
  EXPECT_TRUE(nearest.flank);
  EXPECT_LE(distance(nearest.foot, Vec2(0, 1)), tolerance::rounding());
  EXPECT_NEAR(nearest.distance, 1, tolerance::rounding());
  const std::vector<Vec2> away{{2, 1}, {5, 1}};
  EXPECT_FALSE(nearest_to_origin(away).flank);
}

TEST(NearestPoint, InsideAPolygonLeadsOutTheShortestWay) {
  const std::vector<Vec2> square{{-3, -1}, {3, -1}, {3, 5}, {-3, 5}};
  const NearestPoint nearest = nearest_to_origin(square);
  EXPECT_NEAR(nearest.distance, -1, tolerance::rounding());
  EXPECT_LE(distance(nearest.normal, Vec2(0, 1)), tolerance::rounding());
}

TEST(ConvexPart, ThatIsNotConvexIsNone) {
  EXPECT_EQ(defect_of({{{0, 0}}, 1}), nullptr);
  EXPECT_EQ(defect_of({{{0, 0}, {1, 0}}, 1}), nullptr);
  EXPECT_EQ(defect_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1}), nullptr);
  EXPECT_STREQ(defect_of({{}, 1}), "has no corners");
  EXPECT_STREQ(defect_of({{{0, 0}, {0, 0}}, 1}), "has two corners in one place");
  EXPECT_STREQ(defect_of({{{0, 0}, {1, 0}, {2, 0}}, 1}),
               "is not convex or intersects itself; give it as several convex parts");
  EXPECT_STREQ(defect_of({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 1}), "has its corners clockwise");
  EXPECT_STREQ(defect_of({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 1}),
               "is not convex or intersects itself; give it as several convex parts");
  // A star of five points turns always left, but twice around.
  ConvexPart star{{}, 1};
  for (int k = 0; k < 5; ++k)
    star.corners.emplace_back(std::cos(k * 0.8 * kPi), std::sin(k * 0.8 * kPi));
  EXPECT_STREQ(defect_of(star), "intersects itself");
}

}  // namespace
}  // namespace quicksand
