// The variables of one contact inside the interior-point method, and their elimination; of four contacts where Real is
// Lanes.
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
//
// `here` is 1 where there is such a pair, and 0 in a lane without a contact or friction: all its changes are zero. What no
// contact of the problem has costs nothing.
#pragma once

#include "core/interior_point/contact_lanes.h"

namespace quicksand {

// How far from zero y starts beside x, both at least as far as given: less where x is far, so that no
// product starts far above the least. From unequal ones the first steps are hardly steps at all.
template <class Real>
QUICKSAND_IN_LANES Real start_beside(const Real& x, const Real& least_x, const Real& least_y) {
  constexpr double kSpread = 10;
  return x > kSpread * least_x ? least_y * (kSpread * least_x / x) : least_y;
}

// project_bounded() of projection.h.
template <class Real>
QUICKSAND_IN_LANES Real within(const Real& x, const Real& bound) {
  return smaller(larger(x, Real(-bound)), bound);
}

// A force x with |x| <= limit N that opposes the speed u = a - b: friction or rolling friction.
template <class Real>
struct alignas(sizeof(Real)) BoundedForce {
  Real limit{};                       // 0: not modelled
  Real x{}, low{}, high{}, a{}, b{};  // low = limit N + x, high = limit N - x
  Real dx{}, dlow{}, dhigh{}, da{}, db{};
  Real impedance{}, coupling{}, aim{};  // dx = impedance (aim - du - coupling dN)

  QUICKSAND_IN_LANES void start(const Real& force, const Real& n, const Real& speed,
                                const Real& least_n, const Real& least_speed) {
    const Real none = Real{}, one = none + 1.0, most = limit * n;
    x = within(force, most);
    const Real least_x = limit * least_n, back = -speed;
    low = larger<Real>(most + x, start_beside(speed, least_speed, least_x));
    high = larger<Real>(most - x, start_beside(back, least_speed, least_x));
    a = larger(speed, none) + start_beside(low, least_x, least_speed);
    b = larger(back, none) + start_beside(high, least_x, least_speed);
    x = limit > none ? x : none;
    low = limit > none ? low : one, high = limit > none ? high : one;
    a = limit > none ? a : one, b = limit > none ? b : one;
    dx = dlow = dhigh = da = db = none;
  }
  QUICKSAND_IN_LANES Real here() const {
    const Real none = Real{}, one = none + 1.0;
    return limit > none ? one : none;
  }
  QUICKSAND_IN_LANES void linearise(const Real& n, const Real& speed, const Real& eps) {
    const Real here = this->here();
    defect_low_ = here * (limit * n + x - low);
    defect_high_ = here * (limit * n - x - high);
    defect_speed_ = speed - (a - b);
    per_low_ = 1.0 / low;
    per_high_ = 1.0 / high;
    const Real k_low = a * per_low_, k_high = b * per_high_;
    impedance = here / (k_low + k_high + eps);
    coupling = limit * (k_low - k_high);
  }
  // Aims at products tau; `correct` (1 or 0) adds the second-order terms of the last direction.
  QUICKSAND_IN_LANES void set_targets(double tau, double correct) {
    const Real here = this->here();
    c_a_ = here * (tau - a * low) - correct * (da * dlow);
    c_b_ = here * (tau - b * high) - correct * (db * dhigh);
    find_aim();
  }
  template <class Further>
  QUICKSAND_IN_LANES void adjust_targets(const Further& further) {
    const Real here = this->here();
    Real more;
    further(low, dlow, a, da, more);
    c_a_ += here * more;
    further(high, dhigh, b, db, more);
    c_b_ += here * more;
    find_aim();
  }
  QUICKSAND_IN_LANES void find_direction(const Real& dn, const Real& du) {
    dx = impedance * (aim - du - coupling * dn);
    dlow = limit * dn + dx + defect_low_;
    dhigh = limit * dn - dx + defect_high_;
    da = (c_a_ - a * dlow) * per_low_;
    db = (c_b_ - b * dhigh) * per_high_;
  }
  QUICKSAND_IN_LANES void move(double alpha) {
    x += alpha * dx;
    low += alpha * dlow, high += alpha * dhigh;
    a += alpha * da, b += alpha * db;
  }
  // Of a contact that pushes with n.
  QUICKSAND_IN_LANES Real admissible(const Real& n) const {
    const Real most = limit * n;
    return within(x, most);
  }

 private:
  QUICKSAND_IN_LANES void find_aim() {
    aim =
        (c_a_ - a * defect_low_) * per_low_ - (c_b_ - b * defect_high_) * per_high_ - defect_speed_;
  }

  Real defect_low_{}, defect_high_{}, defect_speed_{}, c_a_{}, c_b_{};
  Real per_low_{}, per_high_{};  // 1/low, 1/high
};

template <class Real>
struct alignas(sizeof(Real)) ContactCone {
  int components = 3;  // modelled, of all lanes: 1 normal, 2 and friction, 3 and rolling friction
  Real here{};
  Real n{}, s{}, dn{}, ds{};
  BoundedForce<Real> slide, roll;

  // Starts from impulse p at relative velocity u (with the offset), kept away from zero.
  QUICKSAND_IN_LANES void start(const Components<Real>& p, const Components<Real>& u,
                                const Real& least_n, const Real& least_speed) {
    n = larger(p.n, start_beside(u.n, least_speed, least_n));
    s = larger(u.n, start_beside(n, least_n, least_speed));
    dn = ds = Real{};
    if (components >= 2) slide.start(p.t, n, u.t, least_n, least_speed);
    if (components >= 3) roll.start(p.r, n, u.r, least_n, least_speed);
  }
  QUICKSAND_IN_LANES void impulse(Components<Real>& p) const { p = {n, slide.x, roll.x}; }

  // Linearises here; returns how the impulse answers to the relative velocity (-dp/du).
  QUICKSAND_IN_LANES void linearise(const Components<Real>& u, const Components<Real>& eps,
                                    Impedance<Real>& d) {
    defect_ = here * (u.n - s);
    per_n_ = 1.0 / n;
    impedance_ = here / (s * per_n_ + eps.n);
    if (components >= 2) slide.linearise(n, u.t, eps.t);
    if (components >= 3) roll.linearise(n, u.r, eps.r);
    d.nn = impedance_;
    d.tt = slide.impedance;
    d.tn = -slide.impedance * slide.coupling * impedance_;
    d.rr = roll.impedance;
    d.rn = -roll.impedance * roll.coupling * impedance_;
  }
  // Aims at products tau; gives dp at du = 0.
  QUICKSAND_IN_LANES void set_targets(double tau, double correct, Components<Real>& dp) {
    c_n_ = (here * (tau - n * s) - correct * (dn * ds)) * per_n_;
    if (components >= 2) slide.set_targets(tau, correct);
    if (components >= 3) roll.set_targets(tau, correct);
    impulse_at_rest(dp);
  }
  // Changes the aims as said above; gives the same.
  template <class Further>
  QUICKSAND_IN_LANES void adjust_targets(const Further& further, Components<Real>& dp) {
    Real more;
    further(n, dn, s, ds, more);
    c_n_ += here * more * per_n_;
    if (components >= 2) slide.adjust_targets(further);
    if (components >= 3) roll.adjust_targets(further);
    impulse_at_rest(dp);
  }
  QUICKSAND_IN_LANES void find_direction(const Components<Real>& du) {
    dn = impedance_ * (c_n_ - defect_ - du.n);
    ds = c_n_ - s * per_n_ * dn;
    if (components >= 2) slide.find_direction(dn, du.t);
    if (components >= 3) roll.find_direction(dn, du.r);
  }
  QUICKSAND_IN_LANES void move(double alpha) {
    n += alpha * dn;
    s += alpha * ds;
    if (components >= 2) slide.move(alpha);
    if (components >= 3) roll.move(alpha);
  }
  // The nearest admissible impulse: none at an open contact, friction within its bounds.
  QUICKSAND_IN_LANES void admissible_impulse(const Real& delassus, Components<Real>& p) const {
    const Real pushes = n * delassus < s ? Real{} : n;
    p = {pushes, slide.admissible(pushes), roll.admissible(pushes)};
  }

  // visit(here, x, dx, y, dy) for each pair of the contact.
  template <class Visit>
  QUICKSAND_IN_LANES void visit_pairs(const Visit& visit) const {
    visit(here, n, dn, s, ds);
    if (components < 2) return;
    visit(slide.here(), slide.low, slide.dlow, slide.a, slide.da);
    visit(slide.here(), slide.high, slide.dhigh, slide.b, slide.db);
    if (components < 3) return;
    visit(roll.here(), roll.low, roll.dlow, roll.a, roll.da);
    visit(roll.here(), roll.high, roll.dhigh, roll.b, roll.db);
  }

 private:
  // dp at du = 0
  QUICKSAND_IN_LANES void impulse_at_rest(Components<Real>& dp) const {
    dp.n = impedance_ * (c_n_ - defect_);
    dp.t = slide.impedance * (slide.aim - slide.coupling * dp.n);
    dp.r = roll.impedance * (roll.aim - roll.coupling * dp.n);
  }

  Real defect_{}, impedance_{}, c_n_{};
  Real per_n_{};  // 1/n
};

}  // namespace quicksand
