// The end of a solution: Newton's method on the modes of the contacts.
//
// Near a solution the trial impulse of each contact tells whether it is open or closed, sticks or slides, holds or
// rolls (projection.h). What is closed, sticks or holds obeys u = 0, what slides R_t = +-friction N, what rolls
// T = +-rolling N. These equations are linear; u = 0 is met by the proximal iteration p := p - u/(eps W), which leaves
// the solution as it is and bounds what redundant contacts may ask for. Modes are read again after each solution [Alart
// 1991].
//
// Interior points end at products above zero: where the bodies that a contact force carries are many or
// heavy, their velocities are still wrong when the residual of every contact is small. This is not so at
// the solution of the linear equations, which costs one more factorisation, or none while modes stay.
#pragma once

#include <cstddef>
#include <vector>

#include "core/interior_point/contact_matrix.h"
#include "core/problem/projection.h"
#include "core/problem/solver_settings.h"

namespace quicksand {

class NewtonOnModes {
 public:
  // Improves `state`, whose velocity is that of its impulses, in at most `max_iterations`, and until the modes
  // stay or velocities have settled; leaves the best state that it met. `matrix` must be attached to the problem.
  SolveReport solve(const ContactProblem& problem, const SolverSettings& settings,
                    int max_iterations, ContactMatrix& matrix, ContactState& state);

 private:
  struct Modes {
    Status normal = Status::open, slide = Status::open, roll = Status::open;
    bool operator==(const Modes&) const = default;
  };

  // Modes, and the impulses' change at dv = 0. Returns whether the modes are those of before.
  bool read_modes(const ContactProblem& problem, const ContactState& state);
  // One component of a closed contact: friction or rolling friction, bounded by `limit` N.
  Status read_bounded(std::size_t contact, int component, double limit, const Vec3& p,
                      const Vec3& q, const Vec3& u, const Vec3& w);

  std::vector<Modes> modes_;                  // (nc)
  std::vector<Impedance<double>> impedance_;  // (nc)
  std::vector<Vec3> change_;                  // (nc) of the impulses
  std::vector<Vec3> dv_;                      // (nb)
  ContactState best_;
};

}  // namespace quicksand
