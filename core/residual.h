// The one judge of every solver.
//
// For each contact, with W the diagonal of its own Delassus block and u the relative velocity,
//   r_n = |N   - max(0, N - (u_n + gap_rate)/W_n)|
//   r_t = |R_t - clamp(R_t - u_t/W_t, -mu N, mu N)|
//   r_r = |T   - clamp(T   - w/W_r,   -mu_r N, mu_r N)| / r,  r the mean arm,
// which all vanish exactly at a solution (natural map, [Acary 2018]). The velocities are those that the
// impulses give, recomputed here, so that no solver can mislead by a stale velocity.
#pragma once

#include "core/solver.h"

namespace quicksand {

// Judges the impulses; `state.velocity` is compared with the velocity that they give.
Residual residual(const ContactProblem& problem, const ContactState& state);

// Velocity that the impulses give (nb).
void velocity_from_impulses(const ContactProblem& problem, const std::vector<Vec3>& impulse,
                            std::vector<Vec3>& velocity);

}  // namespace quicksand
