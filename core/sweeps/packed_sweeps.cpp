#include "core/sweeps/packed_sweeps.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/problem/projection.h"
#include "core/problem/residual.h"

namespace quicksand {

namespace {

// How the bodies' velocity along a direction answers to an impulse along it. Exact for disks, so that equal ones
// are of one kind whatever their direction.
double along(const Vec3& inverse_mass, const Vec2& direction) {
  if (inverse_mass.x() == inverse_mass.y()) return inverse_mass.x();
  return inverse_mass.head<2>().dot(direction.cwiseAbs2());
}

double inverse(double x) { return x > 0 ? 1 / x : 0; }

}  // namespace

PackedSweeps::Kind PackedSweeps::kind_of(const ContactProblem& problem, const ContactRow& row) {
  const Vec3 &ima = problem.inverse_mass[row.a], &imb = problem.inverse_mass[row.b];
  const double ra = row.spin_a.y(), rb = row.spin_b.y();
  const Vec2& n = row.normal;
  const Vec2 t = perpendicular(n);
  return {.ax = ima.x(),
          .ay = ima.y(),
          .a_spin = ima.z(),
          .bx = imb.x(),
          .by = imb.y(),
          .b_spin = imb.z(),
          .arm_a = ra,
          .arm_b = rb,
          .inv_n = inverse(along(ima, n) + along(imb, n)),
          .inv_t = inverse(along(ima, t) + along(imb, t) + ra * ra * ima.z() + rb * rb * imb.z()),
          .inv_r = inverse(ima.z() + imb.z()),
          .friction = problem.components >= 2 ? row.friction : 0,
          .rolling = problem.components >= 3 ? row.rolling : 0,
          .spin_of_tangent = ra * ima.z() + rb * imb.z()};
}

std::int32_t PackedSweeps::number_of(const Kind& kind) {
  // Where every contact is of its own kind, as in a polydisperse packing, a longer look would cost more than the
  // table.
  constexpr std::size_t kLook = 8;
  const std::size_t first = kinds_.size() > kLook ? kinds_.size() - kLook : 0;
  for (std::size_t k = kinds_.size(); k-- > first;)
    if (kinds_[k] == kind) return static_cast<std::int32_t>(k);
  kinds_.push_back(kind);
  return static_cast<std::int32_t>(kinds_.size()) - 1;
}

void PackedSweeps::load(const ContactProblem& problem, const std::vector<Vec3>& impulse) {
  const std::size_t nb = problem.inverse_mass.size(), nc = problem.contacts.size();
  velocity_from_impulses(problem, impulse, velocity_);
  bodies_.resize(nb);
  for (std::size_t i = 0; i < nb; ++i)
    bodies_[i] = {velocity_[i].x(), velocity_[i].y(), velocity_[i].z(), 0};
  kinds_.clear();
  rows_.resize(nc);
  for (std::size_t c = 0; c < nc; ++c) {
    const ContactRow& row = problem.contacts[c];
    assert(row.spin_a.x() == 0 && row.spin_b.x() == 0 && row.offset.y() == 0 &&
           row.offset.z() == 0);
    rows_[c] = {.nx = row.normal.x(),
                .ny = row.normal.y(),
                .offset = row.offset.x(),
                .normal = impulse[c].x(),
                .tangent = impulse[c].y(),
                .rolling = impulse[c].z(),
                .a = row.a,
                .b = row.b,
                .kind = number_of(kind_of(problem, row))};
  }
}

[[gnu::always_inline]] inline void PackedSweeps::visit(Row& row, const Kind* kinds, Body* bodies) {
  const Kind& k = kinds[row.kind];
  Body &a = bodies[row.a], &b = bodies[row.b];
  const double nx = row.nx, ny = row.ny;
  const double ux = b.x - a.x, uy = b.y - a.y;
  const double u_n = row.offset + nx * ux + ny * uy;
  const double u_t = nx * uy - ny * ux + (k.arm_b * b.spin - k.arm_a * a.spin);
  const double w = b.spin - a.spin;

  const double normal = project_normal(row.normal - u_n * k.inv_n);
  const double tangent = project_bounded(row.tangent - u_t * k.inv_t, k.friction * normal);
  const double dn = normal - row.normal, dt = tangent - row.tangent;
  const double turned = w + k.spin_of_tangent * dt;
  const double rolling = project_bounded(row.rolling - turned * k.inv_r, k.rolling * normal);
  const double dr = rolling - row.rolling;
  row.normal = normal;
  row.tangent = tangent;
  row.rolling = rolling;

  const double fx = dn * nx - dt * ny, fy = dn * ny + dt * nx;
  a.x -= k.ax * fx;
  a.y -= k.ay * fy;
  a.spin -= k.a_spin * (dr + k.arm_a * dt);
  b.x += k.bx * fx;
  b.y += k.by * fy;
  b.spin += k.b_spin * (dr + k.arm_b * dt);
}

void PackedSweeps::sweep_at_random(Random& random) {
  // Drawn so far ahead of the visits that the rows are there when they are needed.
  constexpr std::size_t kAhead = 12;
  const std::size_t n = order_.size();
  std::int32_t* const order = order_.data();
  Row* const rows = rows_.data();
  // Fisher and Yates, forward. A draw of 32 bits is off from uniform by n/2^32 at most.
  const auto draw = [&](std::size_t c) {
    const std::size_t at = c + static_cast<std::size_t>(((random.next() >> 32U) * (n - c)) >> 32U);
    const std::int32_t chosen = order[at];
    order[at] = order[c];
    order[c] = chosen;
    __builtin_prefetch(rows + chosen, 1);
  };
  const std::size_t first = std::min(kAhead, n);
  for (std::size_t c = 0; c < first; ++c) draw(c);
  for (std::size_t c = 0; c < n - first; ++c) {
    draw(c + first);
    visit(rows[order[c]], kinds_.data(), bodies_.data());
  }
  for (std::size_t c = n - first; c < n; ++c) visit(rows[order[c]], kinds_.data(), bodies_.data());
}

void PackedSweeps::sweep(int sweeps, SweepOrder order, Random& random) {
  if (order == SweepOrder::random) {
    order_.resize(rows_.size());
    std::iota(order_.begin(), order_.end(), 0);
    for (int k = 0; k < sweeps; ++k) sweep_at_random(random);
    return;
  }
  for (int k = 0; k < sweeps; ++k) {
    const bool back = order == SweepOrder::alternating && k % 2 == 1;
    if (back)
      for (auto row = rows_.rbegin(); row != rows_.rend(); ++row)
        visit(*row, kinds_.data(), bodies_.data());
    else
      for (Row& row : rows_) visit(row, kinds_.data(), bodies_.data());
  }
}

void PackedSweeps::store(std::vector<Vec3>& impulse) const {
  for (std::size_t c = 0; c < rows_.size(); ++c)
    impulse[c] = {rows_[c].normal, rows_[c].tangent, rows_[c].rolling};
}

}  // namespace quicksand
