// One contact inside the interior-point method.
#include "core/interior_point/cone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/base/types.h"

namespace quicksand {
namespace {

constexpr double kLeastN = 1e-2, kLeastSpeed = 2e-2;
const Components<double> kProximal{1e-7, 1e-7, 1e-7};

Components<double> components_of(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

ContactCone<double> cone_at(const Vec3& p, const Vec3& u) {
  ContactCone<double> cone;
  cone.here = 1;
  cone.slide.limit = 0.3;
  cone.roll.limit = 0.05;
  cone.start(components_of(p), components_of(u), kLeastN, kLeastSpeed);
  return cone;
}

const std::vector<Vec3> kImpulses{{0, 0, 0}, {1e-3, 0, 0}, {1, 0.3, 0}, {100, -20, 5}, {1e4, 0, 0}};
const std::vector<Vec3> kSpeeds{{0, 0, 0}, {1e-3, 1, -1}, {50, -3, 0}, {0, 1e-6, 30}};

TEST(ContactCone, StartsInsideAndWithProductsOfOneOrder) {
  for (const Vec3& p : kImpulses)
    for (const Vec3& u : kSpeeds) {
      // What is far from both boundaries is a violation, and as large as it is.
      if (p.x() * u.x() > 0 || p.tail<2>().cwiseProduct(u.tail<2>()).norm() > 0) continue;
      const ContactCone<double> cone = cone_at(p, u);
      const double least = kLeastN * kLeastSpeed;
      EXPECT_GE(cone.n * cone.s, 0.99 * least);
      EXPECT_LE(cone.n * cone.s, 10.01 * least) << p.transpose() << " at " << u.transpose();
      cone.visit_pairs([](double, double x, double, double y, double) {
        EXPECT_GT(x, 0);
        EXPECT_GT(y, 0);
      });
    }
}

// Newton's equations of a pair, x dy + y dx = tau - x y, and with what is aimed at besides.
TEST(ContactCone, DirectionsSolveTheLinearisedProducts) {
  for (const Vec3& p : kImpulses)
    for (const Vec3& u : kSpeeds) {
      ContactCone<double> cone = cone_at(p, u);
      Impedance<double> unused;
      Components<double> dp;
      cone.linearise(components_of(u), kProximal, unused);
      for (const double tau : {0.0, 1e-3, 2.0}) {
        const auto solves = [&](double besides) {
          cone.visit_pairs([&](double, double x, double dx, double y, double dy) {
            const double scale =
                std::max({tau, x * y, std::abs(x * dy), std::abs(y * dx), besides});
            EXPECT_NEAR(x * dy + y * dx, tau - x * y + besides, 1e-9 * scale);
          });
        };
        cone.set_targets(tau, 0, dp);
        cone.find_direction({0.1, -0.2, 0.3});
        solves(0);
        cone.adjust_targets([](double, double, double, double, double& more) { more = 0.5; }, dp);
        cone.find_direction({-0.3, 0, 0.1});
        solves(0.5);
      }
    }
}

// What the directions answer to a relative velocity is what the matrix is filled with.
TEST(ContactCone, AnswersAVelocityByItsImpedance) {
  const Vec3 u(1e-3, 1, -1), du(0.1, -0.2, 0.3);
  ContactCone<double> cone = cone_at({100, -20, 5}, u);
  Impedance<double> d;
  cone.linearise(components_of(u), kProximal, d);
  Eigen::Matrix3d impedance = Vec3(d.nn, d.tt, d.rr).asDiagonal();
  impedance(1, 0) = d.tn;
  impedance(2, 0) = d.rn;
  Components<double> still;
  cone.set_targets(1e-3, 0, still);
  const Vec3 at_rest(still.n, still.t, still.r);
  cone.find_direction(components_of(du));
  const Vec3 dp(cone.dn, cone.slide.dx, cone.roll.dx);
  EXPECT_LE((dp - (at_rest - impedance * du)).norm(), 1e-9 * dp.norm());
}

// A lane does what a contact by itself does, and one without friction moves nothing there.
TEST(ContactCone, LanesAreContacts) {
  const std::array<Vec3, kLanes> impulse{kImpulses[1], kImpulses[2], kImpulses[3], kImpulses[4]};
  const Vec3 u(1e-3, 1, -1), du(0.1, -0.2, 0.3);
  ContactCone<Lanes> four;
  Components<Lanes> p, speed, change, eps;
  Impedance<Lanes> impedance;
  for (std::size_t k = 0; k < kLanes; ++k) {
    four.here[k] = 1;
    four.slide.limit[k] = k == 3 ? 0 : 0.3;
    four.roll.limit[k] = k == 3 ? 0 : 0.05;
    p.n[k] = impulse[k].x(), p.t[k] = impulse[k].y(), p.r[k] = impulse[k].z();
    speed.n[k] = u.x(), speed.t[k] = u.y(), speed.r[k] = u.z();
    change.n[k] = du.x(), change.t[k] = du.y(), change.r[k] = du.z();
    eps.n[k] = eps.t[k] = eps.r[k] = kProximal.n;
  }
  with_lanes([&]() __attribute__((always_inline)) {
    const Lanes none{}, least_n = none + kLeastN, least_speed = none + kLeastSpeed;
    Components<Lanes> dp;
    four.start(p, speed, least_n, least_speed);
    four.linearise(speed, eps, impedance);
    four.set_targets(1e-3, 0, dp);
    four.find_direction(change);
  });
  for (std::size_t k = 0; k + 1 < kLanes; ++k) {
    ContactCone<double> one = cone_at(impulse[k], u);
    Impedance<double> d;
    Components<double> dp;
    one.linearise(components_of(u), kProximal, d);
    one.set_targets(1e-3, 0, dp);
    one.find_direction(components_of(du));
    EXPECT_EQ(four.dn[k], one.dn);
    EXPECT_EQ(four.slide.dx[k], one.slide.dx);
    EXPECT_EQ(four.roll.db[k], one.roll.db);
    EXPECT_EQ(impedance.tn[k], d.tn);
  }
  EXPECT_EQ(four.slide.dx[3], 0);
  EXPECT_EQ(four.slide.dlow[3], 0);
  EXPECT_EQ(four.roll.da[3], 0);
  EXPECT_EQ(impedance.rr[3], 0);
  EXPECT_NE(four.dn[3], 0);
}

}  // namespace
}  // namespace quicksand
