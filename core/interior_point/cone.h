// The variables of one contact inside the interior-point method, and their elimination.
//
// A complementarity pair x y = 0 is followed along x y = tau. Newton's equations of a contact,
//   s dN + N ds = c_n,                ds = du_n + (u_n - s) + eps dN,
//   a dlow + low da = c_a,            dlow  = limit dN + dx + (limit N + x - low),
//   b dhigh + high db = c_b,          dhigh = limit dN - dx + (limit N - x - high),
//   da - db = du + (u - a + b) + eps dx,
// give dN and dx as affine functions of du. The proximal term eps keeps them bounded at stuck
// contacts; it multiplies changes only and so leaves the solution as it is. The slacks low and high
// are variables of their own: limit N - x cannot be recomputed when it is nearly zero.
//
// With the products of a step that is foreseen, `further(x, dx, y, dy)` says by how much the aim of a pair
// is to be changed, which improves the direction without another factorisation [Gondzio 1996].
#pragma once

#include <algorithm>

#include "core/base/types.h"
#include "core/linear/block_lu.h"
#include "core/problem/projection.h"

namespace quicksand {

// How far from zero y starts beside x, both at least as far as given: less where x is far, so that no
// product starts far above the least. From unequal ones the first steps are hardly steps at all.
inline double start_beside(double x, double least_x, double least_y) {
  constexpr double kSpread = 10;
  return x > kSpread * least_x ? least_y * (kSpread * least_x / x) : least_y;
}

// A force x with |x| <= limit N that opposes the speed u = a - b: friction or rolling friction.
struct BoundedForce {
  double limit = 0;                               // 0: not modelled
  double x = 0, low = 0, high = 0, a = 0, b = 0;  // low = limit N + x, high = limit N - x
  double dx = 0, dlow = 0, dhigh = 0, da = 0, db = 0;
  double impedance = 0, coupling = 0, aim = 0;  // dx = impedance (aim - du - coupling dN)

  void start(double force, double n, double speed, double least_n, double least_speed) {
    x = project_bounded(force, limit * n);
    const double least_x = limit * least_n;
    low = std::max(limit * n + x, start_beside(speed, least_speed, least_x));
    high = std::max(limit * n - x, start_beside(-speed, least_speed, least_x));
    a = std::max(speed, 0.0) + start_beside(low, least_x, least_speed);
    b = std::max(-speed, 0.0) + start_beside(high, least_x, least_speed);
    dlow = dhigh = da = db = 0;
  }
  void linearise(double n, double speed, double eps) {
    defect_low_ = limit * n + x - low;
    defect_high_ = limit * n - x - high;
    defect_speed_ = speed - (a - b);
    per_low_ = 1 / low;
    per_high_ = 1 / high;
    const double k_low = a * per_low_, k_high = b * per_high_;
    impedance = 1 / (k_low + k_high + eps);
    coupling = limit * (k_low - k_high);
  }
  // Aims at products tau; `correct` adds the second-order terms of the last direction.
  void set_targets(double tau, bool correct) {
    c_a_ = tau - a * low - (correct ? da * dlow : 0);
    c_b_ = tau - b * high - (correct ? db * dhigh : 0);
    find_aim();
  }
  template <class Further>
  void adjust_targets(Further further) {
    c_a_ += further(low, dlow, a, da);
    c_b_ += further(high, dhigh, b, db);
    find_aim();
  }
  void find_direction(double dn, double du) {
    dx = impedance * (aim - du - coupling * dn);
    dlow = limit * dn + dx + defect_low_;
    dhigh = limit * dn - dx + defect_high_;
    da = (c_a_ - a * dlow) * per_low_;
    db = (c_b_ - b * dhigh) * per_high_;
  }
  void move(double alpha) {
    x += alpha * dx;
    low += alpha * dlow, high += alpha * dhigh;
    a += alpha * da, b += alpha * db;
  }

 private:
  void find_aim() {
    aim =
        (c_a_ - a * defect_low_) * per_low_ - (c_b_ - b * defect_high_) * per_high_ - defect_speed_;
  }

  double defect_low_ = 0, defect_high_ = 0, defect_speed_ = 0, c_a_ = 0, c_b_ = 0;
  double per_low_ = 0, per_high_ = 0;  // 1/low, 1/high
};

struct ContactCone {
  double n = 0, s = 0, dn = 0, ds = 0;
  BoundedForce slide, roll;

  // Starts from impulse p at relative velocity u (with the offset), kept away from zero.
  void start(const Vec3& p, const Vec3& u, double least_n, double least_speed) {
    n = std::max(p.x(), start_beside(u.x(), least_speed, least_n));
    s = std::max(u.x(), start_beside(n, least_n, least_speed));
    dn = ds = 0;
    if (slide.limit > 0) slide.start(p.y(), n, u.y(), least_n, least_speed);
    if (roll.limit > 0) roll.start(p.z(), n, u.z(), least_n, least_speed);
  }
  Vec3 impulse() const { return {n, slide.x, roll.x}; }

  // Linearises here; returns D, how the impulse answers to the relative velocity (-dp/du).
  Mat3 linearise(const Vec3& u, const Vec3& eps) {
    defect_ = u.x() - s;
    per_n_ = 1 / n;
    impedance_ = 1 / (s * per_n_ + eps.x());
    Mat3 d = Mat3::Zero();
    d(0, 0) = impedance_;
    if (slide.limit > 0) {
      slide.linearise(n, u.y(), eps.y());
      d(1, 1) = slide.impedance;
      d(1, 0) = -slide.impedance * slide.coupling * impedance_;
    }
    if (roll.limit > 0) {
      roll.linearise(n, u.z(), eps.z());
      d(2, 2) = roll.impedance;
      d(2, 0) = -roll.impedance * roll.coupling * impedance_;
    }
    return d;
  }
  // Aims at products tau; returns dp at du = 0.
  Vec3 set_targets(double tau, bool correct) {
    c_n_ = (tau - n * s - (correct ? dn * ds : 0)) * per_n_;
    if (slide.limit > 0) slide.set_targets(tau, correct);
    if (roll.limit > 0) roll.set_targets(tau, correct);
    return impulse_at_rest();
  }
  // Changes the aims as said above; returns the same.
  template <class Further>
  Vec3 adjust_targets(Further further) {
    c_n_ += further(n, dn, s, ds) * per_n_;
    if (slide.limit > 0) slide.adjust_targets(further);
    if (roll.limit > 0) roll.adjust_targets(further);
    return impulse_at_rest();
  }
  void find_direction(const Vec3& du) {
    dn = impedance_ * (c_n_ - defect_ - du.x());
    ds = c_n_ - s * per_n_ * dn;
    if (slide.limit > 0) slide.find_direction(dn, du.y());
    if (roll.limit > 0) roll.find_direction(dn, du.z());
  }
  void move(double alpha) {
    n += alpha * dn;
    s += alpha * ds;
    if (slide.limit > 0) slide.move(alpha);
    if (roll.limit > 0) roll.move(alpha);
  }
  // The nearest admissible impulse: none at an open contact, friction within its bounds.
  Vec3 admissible_impulse(double delassus) const {
    if (n * delassus < s) return {0, 0, 0};
    return {n, project_bounded(slide.x, slide.limit * n), project_bounded(roll.x, roll.limit * n)};
  }

  // Raises the smaller factor of every product below `least`.
  void lift(double least) {
    const auto raise = [least](double& x, double& y) {
      if (x * y < least) (x < y ? x : y) = least / std::max(x, y);
    };
    raise(n, s);
    if (slide.limit > 0) raise(slide.low, slide.a), raise(slide.high, slide.b);
    if (roll.limit > 0) raise(roll.low, roll.a), raise(roll.high, roll.b);
  }

  // visit(x, dx, y, dy) for each pair of the contact.
  template <class Visit>
  void visit_pairs(Visit visit) const {
    visit(n, dn, s, ds);
    if (slide.limit > 0) {
      visit(slide.low, slide.dlow, slide.a, slide.da);
      visit(slide.high, slide.dhigh, slide.b, slide.db);
    }
    if (roll.limit > 0) {
      visit(roll.low, roll.dlow, roll.a, roll.da);
      visit(roll.high, roll.dhigh, roll.b, roll.db);
    }
  }

 private:
  // dp at du = 0
  Vec3 impulse_at_rest() const {
    Vec3 dp(impedance_ * (c_n_ - defect_), 0, 0);
    if (slide.limit > 0) dp.y() = slide.impedance * (slide.aim - slide.coupling * dp.x());
    if (roll.limit > 0) dp.z() = roll.impedance * (roll.aim - roll.coupling * dp.x());
    return dp;
  }

  double defect_ = 0, impedance_ = 0, c_n_ = 0;
  double per_n_ = 0;  // 1/n
};

}  // namespace quicksand
