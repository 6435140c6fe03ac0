// The contact law of a pair of bodies: volume exclusion, Coulomb friction, rolling friction and a
// cohesive bond of finite range. [Kadau 2003], [Brendel 2003], [Unger 2002]
//
// With gap g, relative velocity u = (u_n, u_t) and relative spin w (b minus a), and N = R_n + F_c
// for a bonded contact, N = R_n for a plain one:
//   0 <= N,  0 <= g/dt + u_n,  N (g/dt + u_n) = 0
//   |R_t| <= friction N, opposite to u_t where it slides
//   |T|   <= rolling  N, opposite to w  where it rolls
#pragma once

#include <optional>

namespace quicksand {

// A term that is not engaged is not modelled and costs nothing.
struct ContactLaw {
  std::optional<double> friction;          // Coulomb coefficient mu [1]
  std::optional<double> rolling_friction;  // over the effective radius [1]
  std::optional<double> cohesion_force;    // F_c, attraction of an active bond [F_g]
  double cohesion_range = 5e-5;            // d_c, gap at which a bond breaks [d]

  bool operator==(const ContactLaw&) const = default;
};

// Length mu_r that limits the rolling torque [d]: coefficient times 2 r_a r_b/(r_a + r_b), which is
// r for equal disks.
inline double rolling_length(double coefficient, double radius_a, double radius_b) {
  return coefficient * 2 * radius_a * radius_b / (radius_a + radius_b);
}

// The same for a disk on the flank of a shaped body, whose radius is infinite: coefficient times 2 r.
inline double rolling_length_on_flank(double coefficient, double radius) {
  return coefficient * 2 * radius;
}

// The same for a disk on a wall: coefficient times the disk's radius.
inline double rolling_length_on_wall(double coefficient, double radius) {
  return coefficient * radius;
}

}  // namespace quicksand
