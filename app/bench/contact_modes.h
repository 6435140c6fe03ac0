// The second route to a reference solution: which contacts are open, stick, slide and roll is read from
// a state near the solution, and the equations that are linear once this is known are solved directly.
//
// With q = p - u/W (natural map), a contact is closed where q_n > 0, sticks where |q_t| <= friction q_n
// and does not roll where |q_r| <= rolling q_n. Closed and sticking components obey u = 0, met
// by the proximal iteration p := p - u/(eps W); sliding ones obey R_t = +-friction N.
// Modes are read again after each solution, which makes it a Newton method without a central path.
#pragma once

#include "core/solver.h"

namespace quicksand::bench {

// Improves the state as far as its modes allow; the state of least residual that was met is left.
void refine_by_modes(const ContactProblem& problem, ContactState& state);

}  // namespace quicksand::bench
