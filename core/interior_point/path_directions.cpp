// The directions of the interior point's path: its start, its linearisation, and the steps towards products.
#include <algorithm>

#include "core/base/memory.h"
#include "core/interior_point/interior_point.h"
#include "core/interior_point/path_tuning.h"
#include "core/problem/delassus.h"
#include "core/problem/projection.h"

namespace quicksand {

namespace {

using T = PathTuning;

// In the order of the lanes.
double sum(const Lanes& x) { return (x[0] + x[1]) + (x[2] + x[3]); }

// What friction and rolling friction are bounded by, over N; 0 where they are not modelled.
Vec3 bounds_of(const ContactProblem& problem, const ContactRow& row, const Vec3& delassus) {
  return {0, problem.components >= 2 && delassus.y() > 0 ? row.friction : 0,
          problem.components >= 3 && delassus.z() > 0 ? row.rolling : 0};
}

// Speed by which impulse p at relative velocity u is away from the laws.
double violation(const ContactRow& row, const Vec3& delassus, int components, const Vec3& p,
                 const Vec3& u) {
  Vec3 q = p;
  for (int k = 0; k < 3; ++k)
    if (delassus[k] > 0) q[k] -= u[k] / delassus[k];
  const Vec3 off = natural_map(row, components, p, q).cwiseAbs().cwiseProduct(delassus);
  return std::max({off.x(), off.y(), off.z() * row.arm});
}

}  // namespace

void InteriorPoint::Products::add(const Products& other) {
  for (std::size_t k = 0; k < by_power.size(); ++k) by_power[k] += other.by_power[k];
  pairs += other.pairs;
  fastest = fastest > other.fastest ? fastest : other.fastest;
}

// The cones of four contacts, and the impulses they start from; returns by how much the worst is away from the laws. A
// lane beyond the last contact has no pairs; what it starts from only has to be finite.
double InteriorPoint::start_block(const ContactProblem& problem, std::size_t block,
                                  const ContactState& state) {
  const std::size_t nc = problem.contacts.size();
  ContactCone<Lanes>& cone = cone_[block];
  Components<Lanes>&w = softness_[block], &impulse = impulse_[block];
  cone.components = problem.components;
  double worst = 0;
  for (std::size_t k = 0; k < kLanes; ++k) {
    const std::size_t c = kLanes * block + k;
    const auto from = static_cast<std::size_t>(matrix_.order()[c < nc ? c : 0]);
    const ContactRow& row = problem.contacts[from];
    const Vec3& p = state.impulse[from];
    const Vec3 softness =
        delassus_diagonal(row, problem.inverse_mass[row.a], problem.inverse_mass[row.b]);
    const Vec3 bounds = bounds_of(problem, row, softness);
    cone.here[k] = c < nc ? 1 : 0;
    cone.slide.limit[k] = c < nc ? bounds.y() : 0;
    cone.roll.limit[k] = c < nc ? bounds.z() : 0;
    w.n[k] = softness.x(), w.t[k] = softness.y(), w.r[k] = softness.z();
    impulse.n[k] = p.x(), impulse.t[k] = p.y(), impulse.r[k] = p.z();
    const Vec3 u =
        row.offset + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
    worst = std::max(worst, violation(row, softness, problem.components, p, u));
  }
  return worst;
}

void InteriorPoint::start(const ContactProblem& problem, double shift, const ContactState& state) {
  const std::size_t nc = problem.contacts.size(), blocks = lane_blocks(nc);
  set_size(softness_, blocks);
  cone_.assign(blocks, {});
  set_size(impedance_, blocks);
  set_size(impulse_, blocks);

  struct Worst {
    double speed = 0;
    void add(const Worst& other) { speed = std::max(speed, other.speed); }
  };
  const double worst = gather_lane_blocks<Worst>(nc, [&](std::size_t k, Worst& part) {
                         part.speed = std::max(part.speed, start_block(problem, k, state));
                       }).speed;
  const double least_speed = std::max(shift * worst, 1e-12);
  set_momenta(nc);
  matrix_.velocity(velocity_);
  for_lane_blocks(
      nc, [&](std::size_t k) __attribute__((always_inline)) {
        Components<Lanes> u;
        relative_velocity_at(k, u);
        const Lanes least = Lanes{} + least_speed, least_n = least / softness_[k].n;
        cone_[k].start(impulse_[k], u, least_n, least);
        cone_[k].impulse(impulse_[k]);
      });
  set_momenta(nc);
  matrix_.velocity(velocity_);
}

// Momenta of the impulses.
void InteriorPoint::set_momenta(std::size_t contacts) {
  for_lane_blocks(
      contacts, [&](std::size_t k) __attribute__((always_inline)) {
        matrix_.rows()[k].momenta(impulse_[k], matrix_.momenta(k));
      });
}

// H velocity + offset of the impulses of the cones.
[[gnu::always_inline]] inline void InteriorPoint::relative_velocity_at(std::size_t block,
                                                                       Components<Lanes>& u) const {
  const RowLanes& row = matrix_.rows()[block];
  row.relative_velocity(velocity_, u);
  u.n += row.offset.n;
  u.t += row.offset.t;
  u.r += row.offset.r;
}

void InteriorPoint::linearise(const ContactProblem& problem, double proximal) {
  const Products found = gather_lane_blocks<Products>(
      problem.contacts.size(), [&](std::size_t k, Products & part) __attribute__((always_inline)) {
        Components<Lanes> u;
        relative_velocity_at(k, u);
        const Components<Lanes>& w = softness_[k];
        const Components<Lanes> eps{proximal * w.n, proximal * w.t, proximal * w.r};
        cone_[k].linearise(u, eps, impedance_[k]);
        Components<Lanes> dp;  // the predictor's, which nearly always comes first
        cone_[k].set_targets(0, 0, dp);
        matrix_.rows()[k].momenta(dp, matrix_.momenta(k));
        cone_[k].visit_pairs([&](const Lanes& here, const Lanes& x, const Lanes&, const Lanes& y,
                                 const Lanes&) __attribute__((always_inline)) {
          part.by_power[0] += here * (x * y);
          part.pairs += here;
        });
      });
  products_ = {sum(found.by_power[0]), 0, 0};  // no direction yet
  pairs_ = sum(found.pairs);
  matrix_.factorise(impedance_);
}

double InteriorPoint::find_direction(const ContactProblem& problem, double tau, bool correct) {
  const double weight = correct ? 1 : 0;
  for_lane_blocks(
      problem.contacts.size(), [&](std::size_t k) __attribute__((always_inline)) {
        Components<Lanes> dp;
        cone_[k].set_targets(tau, weight, dp);
        matrix_.rows()[k].momenta(dp, matrix_.momenta(k));
      });
  return follow(problem);
}

double InteriorPoint::centre_direction(const ContactProblem& problem, double tau, double alpha) {
  const double foreseen = std::min(1.0, alpha + T::kFurther);
  const auto further = [&](const Lanes& x, const Lanes& dx, const Lanes& y, const Lanes& dy,
                           Lanes& more) __attribute__((always_inline)) {
    const Lanes product = (x + foreseen * dx) * (y + foreseen * dy), none{};
    const Lanes least = none + T::kLeastOfAim * tau, most = none + T::kMostOfAim * tau;
    more = larger<Lanes>(smaller(larger(product, least), most) - product, -most);
  };
  for_lane_blocks(
      problem.contacts.size(), [&](std::size_t k) __attribute__((always_inline)) {
        Components<Lanes> dp;
        cone_[k].adjust_targets(further, dp);
        matrix_.rows()[k].momenta(dp, matrix_.momenta(k));
      });
  return follow(problem);
}

double InteriorPoint::follow(const ContactProblem& problem) {
  const BodyVectors& change = matrix_.velocity_change();
  const Products found = gather_lane_blocks<Products>(
      problem.contacts.size(), [&](std::size_t k, Products & part) __attribute__((always_inline)) {
        Components<Lanes> du;
        matrix_.rows()[k].relative_velocity(change, du);
        cone_[k].find_direction(du);
        cone_[k].visit_pairs([&](const Lanes&, const Lanes& x, const Lanes& dx, const Lanes& y,
                                 const Lanes& dy) __attribute__((always_inline)) {
          // The faster of -dx/x and -dy/y, by one division.
          const Lanes ax = -dx * y, ay = -dy * x, scale = x * y;
          part.fastest = larger<Lanes>(part.fastest, larger(ax, ay) / scale);
          part.by_power[1] += x * dy + y * dx;
          part.by_power[2] += dx * dy;
        });
      });
  products_[1] = sum(found.by_power[1]);
  products_[2] = sum(found.by_power[2]);
  double fastest = 0;
  for (std::size_t k = 0; k < kLanes; ++k) fastest = std::max(fastest, found.fastest[k]);
  return 1 / fastest;
}

double InteriorPoint::mean_product(double alpha) const {
  const std::array<double, 3>& p = products_;
  return pairs_ > 0 ? (p[0] + alpha * (p[1] + alpha * p[2])) / pairs_ : 0;
}

}  // namespace quicksand
