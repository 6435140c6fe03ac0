// Sweeps of projected Gauss-Seidel over a contact problem that is packed for speed. [Jean 1999]
//
// One visit of a contact projects its trial impulse on its laws (projection.h), N, then R_t, then T, and hands the
// changes on to the velocities. Between disks and walls N acts on neither u_t nor w; R_t acts on w by
// c_tr = r_a/I_a - r_b/I_b, which is 0 for equal disks.
//
// A contact is a row of 64 bytes and a body one of 32, so that a visit of 5000 equal grains reads 128 bytes and
// writes 88; inverse masses, arms and coefficients are in a table of kinds of contacts, of which a packing of
// equal grains has a handful.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/problem/contact_problem.h"
#include "core/sweeps/nscd_settings.h"

namespace quicksand {

class PackedSweeps {
 public:
  // Takes problem and impulses; velocities follow from them.
  void load(const ContactProblem& problem, const std::vector<Vec3>& impulse);
  // So many further sweeps; `random` is drawn from for a random order only.
  void sweep(int sweeps, SweepOrder order, Random& random);
  // Impulses (nc) as they are now.
  void store(std::vector<Vec3>& impulse) const;

  // Memory that a visit of a contact may touch: its row and both bodies, without the table of kinds. [bytes]
  static constexpr std::size_t kBytesPerUpdate = 64 + 2 * 32;
  std::size_t kinds() const { return kinds_.size(); }

 private:
  struct alignas(32) Body {
    double x = 0, y = 0;  // velocity [sqrt(g d)]
    double spin = 0;      // [sqrt(g/d)]
    double unused = 0;
  };
  struct alignas(64) Row {
    double nx = 0, ny = 0;                        // unit, from a to b [1]
    double offset = 0;                            // [sqrt(g d)]
    double normal = 0, tangent = 0, rolling = 0;  // impulse (N, R_t, T)
    std::int32_t a = 0, b = 0;
    std::int32_t kind = 0, unused = 0;
  };
  struct Kind {
    double ax = 0, ay = 0, a_spin = 0;  // inverse mass of a: x, y, rotation [1/m], [1/I]
    double bx = 0, by = 0, b_spin = 0;
    double arm_a = 0, arm_b = 0;             // ContactRow::spin_a.y, spin_b.y [d]
    double inv_n = 0, inv_t = 0, inv_r = 0;  // 1/W; 0 where nothing moves
    double friction = 0, rolling = 0;        // [1], [d]
    double spin_of_tangent = 0;              // c_tr
    bool operator==(const Kind&) const = default;
  };
  static Kind kind_of(const ContactProblem& problem, const ContactRow& row);
  std::int32_t number_of(const Kind& kind);
  static void visit(Row& row, const Kind* kinds, Body* bodies);
  void sweep_at_random(Random& random);

  std::vector<Vec3> velocity_;       // (nb) before the sweeps
  std::vector<Body> bodies_;         // (nb)
  std::vector<Row> rows_;            // (nc)
  std::vector<Kind> kinds_;          // few
  std::vector<std::int32_t> order_;  // (nc) of a random sweep
};

}  // namespace quicksand
