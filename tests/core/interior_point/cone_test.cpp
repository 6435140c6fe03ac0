// One contact inside the interior-point method.
#include "core/interior_point/cone.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

constexpr double kLeastN = 1e-2, kLeastSpeed = 2e-2;
const Vec3 kProximal(1e-7, 1e-7, 1e-7);

ContactCone cone_at(const Vec3& p, const Vec3& u) {
  ContactCone cone;
  cone.slide.limit = 0.3;
  cone.roll.limit = 0.05;
  cone.start(p, u, kLeastN, kLeastSpeed);
  return cone;
}

const std::vector<Vec3> kImpulses{{0, 0, 0}, {1e-3, 0, 0}, {1, 0.3, 0}, {100, -20, 5}, {1e4, 0, 0}};
const std::vector<Vec3> kSpeeds{{0, 0, 0}, {1e-3, 1, -1}, {50, -3, 0}, {0, 1e-6, 30}};

TEST(ContactCone, StartsInsideAndWithProductsOfOneOrder) {
  for (const Vec3& p : kImpulses)
    for (const Vec3& u : kSpeeds) {
      // What is far from both boundaries is a violation, and as large as it is.
      if (p.x() * u.x() > 0 || p.tail<2>().cwiseProduct(u.tail<2>()).norm() > 0) continue;
      const ContactCone cone = cone_at(p, u);
      const double least = kLeastN * kLeastSpeed;
      EXPECT_GE(cone.n * cone.s, 0.99 * least);
      EXPECT_LE(cone.n * cone.s, 10.01 * least) << p.transpose() << " at " << u.transpose();
      cone.visit_pairs([](double x, double, double y, double) {
        EXPECT_GT(x, 0);
        EXPECT_GT(y, 0);
      });
    }
}

// Newton's equations of a pair, x dy + y dx = tau - x y, and with what is aimed at besides.
TEST(ContactCone, DirectionsSolveTheLinearisedProducts) {
  for (const Vec3& p : kImpulses)
    for (const Vec3& u : kSpeeds) {
      ContactCone cone = cone_at(p, u);
      cone.linearise(u, kProximal);
      for (const double tau : {0.0, 1e-3, 2.0}) {
        const auto solves = [&](double besides) {
          cone.visit_pairs([&](double x, double dx, double y, double dy) {
            const double scale =
                std::max({tau, x * y, std::abs(x * dy), std::abs(y * dx), besides});
            EXPECT_NEAR(x * dy + y * dx, tau - x * y + besides, 1e-9 * scale);
          });
        };
        cone.set_targets(tau, false);
        cone.find_direction({0.1, -0.2, 0.3});
        solves(0);
        cone.adjust_targets([](double, double, double, double) { return 0.5; });
        cone.find_direction({-0.3, 0, 0.1});
        solves(0.5);
      }
    }
}

// What the directions answer to a relative velocity is what the matrix is filled with.
TEST(ContactCone, AnswersAVelocityByItsImpedance) {
  const Vec3 u(1e-3, 1, -1), du(0.1, -0.2, 0.3);
  ContactCone cone = cone_at({100, -20, 5}, u);
  const Mat3 impedance = cone.linearise(u, kProximal);
  const Vec3 at_rest = cone.set_targets(1e-3, false);
  cone.find_direction(du);
  const Vec3 dp(cone.dn, cone.slide.dx, cone.roll.dx);
  EXPECT_LE((dp - (at_rest - impedance * du)).norm(), 1e-9 * dp.norm());
}

}  // namespace
}  // namespace quicksand
