// Contacts four at a time, one in each lane: how the interior-point method sees a contact problem. Bodies are in the
// order of elimination, each a vector over a fourth number that means nothing.
//
// All that touches lanes must be inlined into a lambda of with_lanes() (core/base/lanes.h).
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/base/lanes.h"
#include "core/base/parallel.h"
#include "core/problem/contact_problem.h"

#define QUICKSAND_IN_LANES [[gnu::always_inline]] inline

namespace quicksand {

inline constexpr std::size_t kLanes = 4;

inline std::size_t lane_blocks(std::size_t contacts) { return (contacts + kLanes - 1) / kLanes; }

template <class Real>
QUICKSAND_IN_LANES Real larger(const Real& x, const Real& y) {
  return x > y ? x : y;
}
template <class Real>
QUICKSAND_IN_LANES Real smaller(const Real& x, const Real& y) {
  return x < y ? x : y;
}

// Normal, tangential and rotational component of an impulse or a relative velocity.
template <class Real>
struct alignas(sizeof(Real)) Components {
  Real n{}, t{}, r{};
};

// -dp/du of a contact: the first column and the diagonal of a matrix that is zero elsewhere (see cone.h).
template <class Real>
struct alignas(sizeof(Real)) Impedance {
  Real nn{}, tn{}, tt{}, rn{}, rr{};
};
inline Vec3 operator*(const Impedance<double>& d, const Vec3& u) {
  return {d.nn * u.x(), d.tn * u.x() + d.tt * u.y(), d.rn * u.x() + d.rr * u.z()};
}

using BodyVectors = std::vector<Eigen::Vector4d>;

// Four rows become four columns.
QUICKSAND_IN_LANES void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

// Vectors of four bodies, x, y and turning in a register each.
struct alignas(sizeof(Lanes)) BodyLanes {
  Lanes x, y, z;
};
QUICKSAND_IN_LANES void gather(const BodyVectors& of_body, const std::array<int, kLanes>& body,
                               BodyLanes& lanes) {
  Lanes unused;
  load_lanes(of_body[static_cast<std::size_t>(body[0])].data(), lanes.x);
  load_lanes(of_body[static_cast<std::size_t>(body[1])].data(), lanes.y);
  load_lanes(of_body[static_cast<std::size_t>(body[2])].data(), lanes.z);
  load_lanes(of_body[static_cast<std::size_t>(body[3])].data(), unused);
  transpose(lanes.x, lanes.y, lanes.z, unused);
}

// The geometry of four rows of a contact problem.
struct alignas(sizeof(Lanes)) RowLanes {
  std::array<int, kLanes> a{}, b{};  // places of the bodies
  Lanes normal_x{}, normal_y{};
  Lanes spin_a_n{}, spin_a_t{}, spin_b_n{}, spin_b_t{};
  Components<Lanes> offset;

  QUICKSAND_IN_LANES void relative_velocity(const BodyVectors& velocity,
                                            Components<Lanes>& u) const {
    BodyLanes va, vb;
    gather(velocity, a, va);
    gather(velocity, b, vb);
    const Lanes x = vb.x - va.x, y = vb.y - va.y;
    u.n = normal_x * x + normal_y * y + spin_b_n * vb.z - spin_a_n * va.z;
    u.t = normal_x * y - normal_y * x + spin_b_t * vb.z - spin_a_t * va.z;
    u.r = vb.z - va.z;
  }

  // What an impulse does to the momenta of its bodies, two vectors a contact: that of a, and that of b.
  QUICKSAND_IN_LANES void momenta(const Components<Lanes>& p, Eigen::Vector4d* of_side) const {
    const Lanes x = p.n * normal_x - p.t * normal_y, y = p.n * normal_y + p.t * normal_x;
    const auto put = [&](Lanes px, Lanes py, Lanes turn, Eigen::Vector4d * to)
        __attribute__((always_inline)) {
      Lanes none{};
      transpose(px, py, turn, none);
      store_lanes(px, to[0].data());
      store_lanes(py, to[2].data());
      store_lanes(turn, to[4].data());
      store_lanes(none, to[6].data());
    };
    put(-x, -y, -(p.r + spin_a_n * p.n + spin_a_t * p.t), of_side);
    put(x, y, p.r + spin_b_n * p.n + spin_b_t * p.t, of_side + 1);
  }
};

// work(k) for all k below n, shared by the cores from `worth` on.
template <class Work>
void share_in_lanes(std::size_t n, const Work& work, std::size_t worth = parallel::kWorthSharing) {
  share_range(
      n,
      [&](std::size_t begin, std::size_t end) {
        with_lanes([&]() __attribute__((always_inline)) {
          for (std::size_t k = begin; k < end; ++k) work(k);
        });
      },
      worth);
}

// work(block) for all blocks of so many contacts.
template <class Work>
void for_lane_blocks(std::size_t contacts, const Work& work) {
  share_in_lanes(lane_blocks(contacts), work, parallel::kWorthSharing / kLanes);
}

// The same, gathered: collect(block, sum).
template <class T, class Collect>
T gather_lane_blocks(std::size_t contacts, const Collect& collect) {
  return gather_range<T>(
      lane_blocks(contacts),
      [&](std::size_t begin, std::size_t end, T& part) {
        with_lanes([&]() __attribute__((always_inline)) {
          for (std::size_t k = begin; k < end; ++k) collect(k, part);
        });
      },
      parallel::kWorthSharing / kLanes);
}

}  // namespace quicksand
