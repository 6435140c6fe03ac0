// Standard nonsmooth contact dynamics (NSCD), as most of its literature computes: a step is a fixed number of sweeps
// of projected Gauss-Seidel from the impulses of the step before, taken as it is. [Jean 1999], [Kadau 2003]
//
// What the sweeps have not reached acts as a spurious elasticity of the contacts [Unger 2002]: in a chain of n
// contacts a disturbance spreads like a diffusion, n^2 sweeps far. So the answer depends on the number of sweeps and
// on the time step together, and is a limit of neither. Residual, gap error and penetration say by how much a step
// is off; they decide nothing.
#pragma once

#include "core/base/log_histogram.h"
#include "core/problem/solver_settings.h"
#include "core/sweeps/nscd_settings.h"
#include "core/sweeps/packed_sweeps.h"

namespace quicksand {

// By how much the sweeps of a step are off.
struct SweptStep {
  double residual = 0;     // Residual::natural [1]
  double bond_gap = 0;     // widest gap of a loaded bonded contact after the step, either way [d]
  double penetration = 0;  // deepest overlap that the step leaves at a contact [d]
};
SweptStep swept_step(const ContactProblem& problem, const ContactState& state,
                     const Residual& residual);

// Of all steps.
struct SweepErrors {
  LogHistogram residual, bond_gap, penetration;
  void add(const SweptStep& step) {
    residual.add(step.residual);
    bond_gap.add(step.bond_gap);
    penetration.add(step.penetration);
  }
};

// Holds scratch memory only.
class NscdSweeps {
 public:
  // The sweeps of one step, from the impulses of `state`. Converged says whether the exact method would have
  // accepted the step by `accepted`; the iterations are sweeps. Draws from `random` for a random order only.
  SolveReport solve(const ContactProblem& problem, const Nscd& nscd, const SolverSettings& accepted,
                    ContactState& state, Random& random);

 private:
  PackedSweeps packed_;
};

}  // namespace quicksand
