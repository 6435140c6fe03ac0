// Projected nonlinear Gauss-Seidel, the field's reference method. [Jean 1999], [Unger 2002]
#pragma once

#include "core/problem/contact_problem.h"
#include "core/problem/solver_settings.h"
#include "core/problem/work_clock.h"

namespace quicksand {

// Sweeps over the contacts in their order, each solved exactly against the present velocities of its
// two bodies, until the residual is below the tolerance or the sweeps are used up. Looks up to `clock` in between, which
// may be null. Throws GivenUp.
SolveReport solve_gauss_seidel(const ContactProblem& problem, const SolverSettings& settings,
                               ContactState& state, WorkClock* clock = nullptr);

}  // namespace quicksand
