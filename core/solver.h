// What a contact solver reads, writes and reports. A solver is one file behind this interface.
//
// Unknowns are, for each contact, the impulse (N, R_t, T) on body b, and for each body the velocity
//   v = free_velocity + M^-1 H^T impulse,
// such that with u = (u_n, u_t, w) = H v + offset, the relative velocity of b to a at the contact and
// in n what is left of the gap,
//   0 <= N      complementary to  u_n >= 0
//   |R_t| <= friction N,  opposite to u_t where it slides
//   |T|   <= rolling  N,  opposite to w where it rolls.
// Cohesion is not a solver's business: it enters free_velocity as a known pair of impulses -F_c dt
// along the normal, so that N = R_n + F_c dt. [Kadau 2003]
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/types.h"

namespace quicksand {

struct ContactRow {
  int a = 0;  // body indices into the problem's arrays
  int b = 0;
  Vec2 normal{0, 0};  // unit, from a to b; the tangent is perpendicular(normal)
  Vec2 spin_a{0, 0};  // velocity (normal, tangential) of the contact point of a unit spin of a [d]
  Vec2 spin_b{0, 0};  // and of b; a disk has (0, radius) as a and (0, -radius) as b
  Vec3 offset{0, 0, 0};      // n: gap/dt, and the curvature term of bonded contacts [sqrt(g d)]
  double arm = 1;            // mean radius of the bodies at the contact, the length scale of T [d]
  double friction = 0;       // [1]
  double rolling = 0;        // [d]
  double gap_tolerance = 0;  // admissible |gap error| where N > 0 [d]
  bool cohesive = false;     // whether free_velocity has an attraction of this contact
};

// Relative velocity H v of b to a at the contact, without the offset.
inline Vec3 relative_velocity(const ContactRow& c, const Vec3& va, const Vec3& vb) {
  const Vec2 dv = vb.head<2>() - va.head<2>();
  return {c.normal.dot(dv) + c.spin_b.x() * vb.z() - c.spin_a.x() * va.z(),
          perpendicular(c.normal).dot(dv) + c.spin_b.y() * vb.z() - c.spin_a.y() * va.z(),
          vb.z() - va.z()};
}

// Transpose of the above: what an impulse (N, R_t, T) does to the momenta of b and of a.
inline Vec3 momentum_of_b(const ContactRow& c, const Vec3& p) {
  const Vec2 f = p.x() * c.normal + p.y() * perpendicular(c.normal);
  return {f.x(), f.y(), p.z() + c.spin_b.dot(p.head<2>())};
}
inline Vec3 momentum_of_a(const ContactRow& c, const Vec3& p) {
  const Vec2 f = p.x() * c.normal + p.y() * perpendicular(c.normal);
  return {-f.x(), -f.y(), -p.z() - c.spin_a.dot(p.head<2>())};
}

// Built once a step, constant while solving.
struct ContactProblem {
  double dt = 0;              // [sqrt(d/g)]
  double force_scale = 1;     // forces are judged relative to this [F_g]
  double velocity_scale = 1;  // and velocities relative to this [sqrt(g d)]
  int components = 3;  // modelled: 1 normal (of disks), 2 and friction, 3 and rolling friction
  std::vector<Vec3> inverse_mass;    // (nb) (1/m, 1/m, 1/I)
  std::vector<Vec3> free_velocity;   // (nb) velocity at the end of the step without contacts
  std::vector<ContactRow> contacts;  // (nc)
};

struct ContactState {
  std::vector<Vec3> velocity;  // (nb)
  std::vector<Vec3> impulse;   // (nc); on entry the warm start
};

// Distance of a state from the contact laws; see residual.h.
struct Residual {
  double natural = 0;  // worst projection residual over force_scale dt [1]
  double gap = 0;      // worst |gap error| over gap_tolerance where N > 0 [1]
};

// A word in the scene for each method; `automatic` ("auto") is the ladder described in solver.cpp.
enum class Method : std::uint8_t { automatic, interior_point, gauss_seidel };

struct SolverSettings {
  Method method = Method::automatic;
  double tolerance = 1e-6;          // on Residual::natural [1]
  double velocity_tolerance = 0.1;  // on SolveReport::velocity_change [1]
  int max_iterations = 20000;       // sweeps of Gauss-Seidel, or as much relaxation
  int max_factorisations = 80;      // of one interior-point attempt
  bool patient = true;              // of `automatic`: goes on as long as anything is gained

  bool operator==(const SolverSettings&) const = default;

  // A start is taken as it is where its distance from acceptance is this. One that is just acceptable is
  // not: what is wrong with its velocities would be handed on from step to step.
  static constexpr double kAsItIs = 1e-5;

  // At most 1 where a solution is accepted: both the residual and the gap error count. The interior
  // point goes on for a few iterations, as far as they help, until velocities have settled too.
  double distance(const Residual& r) const { return std::max(r.natural / tolerance, r.gap); }
  bool accepts(const Residual& r) const { return distance(r) <= 1; }
};

// What found the solution; see solver.cpp.
enum class Rung : std::uint8_t { start, locality, interior_point, far_start, polish };

// Not converging is an answer: the caller decides.
struct SolveReport {
  bool converged = false;
  Rung rung = Rung::start;
  Residual residual;
  // Fastest change of velocity at a contact in the last iteration of Newton's method, over the scale. As
  // it converges quadratically, the error left is far smaller. 0 where nothing was iterated, and not
  // known of Gauss-Seidel and of relaxation, which leave it.
  double velocity_change = 0;
  std::int64_t iterations = 0;
  std::int64_t factorisations = 0;

  // Takes over the outcome of a further solution and sums up the work.
  void add(const SolveReport& further) {
    converged = further.converged;
    rung = further.rung;
    residual = further.residual;
    velocity_change = further.velocity_change;
    iterations += further.iterations;
    factorisations += further.factorisations;
  }
};

// Keeps scratch memory and what can be reused between problems with the same contacts; the answer
// depends on the problem, the settings and the warm start only.
class ContactSolver {
 public:
  ContactSolver();
  ~ContactSolver();
  ContactSolver(const ContactSolver&) = delete;
  ContactSolver& operator=(const ContactSolver&) = delete;

  // `from`: what solved a problem much like this one; easier ways are not tried again.
  SolveReport solve(const ContactProblem& problem, const SolverSettings& settings,
                    ContactState& state, Rung from = Rung::start);
  // The same for a problem that was solved by `from` but for some contacts that have come in since.
  SolveReport solve_with_more(const ContactProblem& problem, const SolverSettings& settings,
                              ContactState& state, Rung from);

 private:
  struct Methods;
  std::unique_ptr<Methods> methods_;
};

// A single problem.
inline SolveReport solve(const ContactProblem& problem, const SolverSettings& settings,
                         ContactState& state) {
  return ContactSolver().solve(problem, settings, state);
}

}  // namespace quicksand
