// Primal-dual interior point on the exact, non-associated problem, with Mehrotra's predictor and
// corrector [Mehrotra 1992], in velocity space.
//
// In two dimensions the laws are products of non-negative pairs: with s = u_n,
//   N s = 0
//   (mu N + R_t) a = 0,  (mu N - R_t) b = 0,   u_t = a - b
//   (mu_r N + T) a' = 0, (mu_r N - T) b' = 0,  w = a' - b'.
// All products are driven together to zero, along a path that starts at large ones. Where contacts slide
// the problem is not monotone and the path may fold: products that are asked to shrink further have no
// solution near. Beyond a fold the path goes on with growing products, until it folds again. Its
// direction is that of the determinant of Newton's matrix, positive at the start, so the products are
// made to grow where that is negative [Allgower 1990]. The variables of a contact are eliminated by hand (see
// cone.h), which leaves (M + H^T D H) dv = H^T dp with one 3x3 block D a contact; it is
// not symmetric where a contact slides.
#pragma once

#include <array>
#include <vector>

#include "core/interior_point/cone.h"
#include "core/interior_point/contact_lanes.h"
#include "core/interior_point/contact_matrix.h"
#include "core/interior_point/newton_on_modes.h"
#include "core/problem/contact_problem.h"
#include "core/problem/solver_settings.h"
#include "core/sweeps/relaxation.h"

namespace quicksand {

// Keeps the order of elimination while the contacts stay the same, and its scratch memory.
class InteriorPoint {
 public:
  // `clock`, if any, is told where the time goes.
  explicit InteriorPoint(WorkClock* clock = nullptr) : clock_(clock), matrix_(clock) {}

  // Starts from state.impulse, at a distance from the boundary of `shift` times the violation found
  // there, and leaves the best state that it met.
  SolveReport solve(const ContactProblem& problem, const SolverSettings& settings, double shift,
                    ContactState& state);

  // Relaxes state.impulse (see core/sweeps/relaxation.h); where that converges, some iterations of Newton's method
  // on the modes follow, which also tell the change of velocity.
  SolveReport relax(const ContactProblem& problem, const SolverSettings& settings,
                    ContactState& state);

 private:
  // Of some of the pairs, by lanes.
  struct alignas(sizeof(Lanes)) Products {
    std::array<Lanes, 3> by_power{};  // their sum after a step of alpha, by powers of alpha
    Lanes pairs{};
    Lanes fastest = Lanes{} + 1e-3;  // the largest relative decrease of a factor, at least this
    void add(const Products& other);
  };

  double start_block(const ContactProblem& problem, std::size_t block, const ContactState& state);
  void start(const ContactProblem& problem, double shift, const ContactState& state);
  // Proximal term over each contact's Delassus diagonal [1].
  void linearise(const ContactProblem& problem, double proximal);
  // Heads for products tau; returns the step that reaches the boundary.
  double find_direction(const ContactProblem& problem, double tau, bool correct);
  // The same for products that such a step of alpha would leave well within bounds.
  double centre_direction(const ContactProblem& problem, double tau, double alpha);
  double follow(const ContactProblem& problem);
  void relative_velocity_at(std::size_t block, Components<Lanes>& u) const;
  void set_momenta(std::size_t contacts);
  double find_step(const ContactProblem& problem, double product);
  bool finish(const ContactProblem& problem, const SolverSettings& settings, ContactState& state,
              SolveReport& report);
  struct Path;
  void iterate(Path& path);
  bool accept(Path& path);
  bool rescue(Path& path);
  double mean_product(double alpha) const;  // after a step of alpha along the direction

  WorkClock* clock_;
  ContactMatrix matrix_;
  NewtonOnModes newton_;
  std::array<double, 3> products_{};  // their sum after a step of alpha, by powers of alpha
  double pairs_ = 0;
  // Four contacts a block; bodies by places (contact_lanes.h).
  std::vector<Components<Lanes>> softness_;  // the Delassus diagonals
  std::vector<ContactCone<Lanes>> cone_;
  std::vector<Impedance<Lanes>> impedance_;
  std::vector<Components<Lanes>> impulse_;
  BodyVectors velocity_;    // that the impulses of the cones give
  std::vector<Vec3> best_;  // (nc)
  ContactState relaxed_;
  RelaxationScratch relaxation_;
};

}  // namespace quicksand
