// Speed against error: how far a solver's velocities are from those of the solution, and how long
// Gauss-Seidel takes to come as close.
//
// Residuals of different methods are no common measure: on a network Gauss-Seidel at a residual of 1e-6
// can be as wrong as free fall. Velocities are compared instead, as the worst over the bodies in units
// of g dt, the velocity of free fall over a step.
#pragma once

#include <vector>

#include "app/bench/bench.h"
#include "app/bench/step_problem.h"
#include "core/problem/solver_settings.h"

namespace quicksand::bench {

// Velocities of the solution.
struct Reference {
  std::vector<Vec3> velocity;  // (nb)
  Residual residual;
  double doubt = 0;  // distance between those of the two routes [g dt]
};

// max over bodies of |v - w|, centres only [g dt].
double velocity_distance(const ContactProblem& problem, const std::vector<Vec3>& v,
                         const std::vector<Vec3>& w);

// Two routes, of which the one of smaller residual is taken: the fallback chain of "auto" from the warm-started
// impulses at a tolerance of 1e-12, and the same from other impulses, followed by the direct solution
// with the modes of the contacts (contact_modes.h). The residual that was reached is stated.
Reference solve_tightly(const StepProblem& step);

// Solves once from `start`, timed.
Row measure_solution(const StepProblem& step, const std::vector<Vec3>& start,
                     const SolverSettings& settings, const Reference& reference,
                     const Options& options);

// Gauss-Seidel from `start` until its velocity error is at most `error`, in portions of a tenth of the
// sweeps done, or until the patience is used up.
Row measure_gauss_seidel(const StepProblem& step, const std::vector<Vec3>& start, double error,
                         const Reference& reference, const Options& options);

}  // namespace quicksand::bench
