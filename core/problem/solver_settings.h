// What a solver is asked for, and what it reports.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/problem/residual.h"

namespace quicksand {

// A word in the scene for each method; `automatic` ("auto") is the fallback chain described in contact_solver.cpp.
enum class Method : std::uint8_t { automatic, interior_point, gauss_seidel };

struct SolverSettings {
  Method method = Method::automatic;
  double tolerance = 1e-6;          // on Residual::natural [1]
  double velocity_tolerance = 0.1;  // on SolveReport::velocity_change [1]
  int max_iterations = 20000;       // sweeps of Gauss-Seidel, or as much relaxation
  int max_factorisations = 80;      // of one interior-point attempt
  bool patient = true;              // of `automatic`: goes on as long as anything is gained

  bool operator==(const SolverSettings&) const = default;

  // A start at rest is taken as it is where its distance from acceptance is this; see rest.h.
  static constexpr double kAsItIs = 1e-5;

  // At most 1 where a solution is accepted: both the residual and the gap error count. The interior
  // point goes on for a few iterations, as far as they help, until velocities have settled too.
  double distance(const Residual& r) const { return std::max(r.natural / tolerance, r.gap); }
  bool accepts(const Residual& r) const { return distance(r) <= 1; }
  // The residual whose distance is so large.
  Residual residual_at(double distance) const {
    return {.natural = distance * tolerance, .gap = distance};
  }
};

// What found the solution; see contact_solver.cpp.
enum class SolverStage : std::uint8_t { start, local, interior_point, far_start, sweeps };

// Not converging is an answer: the caller decides.
struct SolveReport {
  bool converged = false;
  SolverStage stage = SolverStage::start;
  Residual residual;
  // Fastest change of velocity at a contact in the last iteration of Newton's method, over the scale. As
  // it converges quadratically, the error left is far smaller. Empty where it is not known of the state: of a start
  // that is taken as it is, of Gauss-Seidel and of relaxation.
  std::optional<double> velocity_change;
  std::int64_t iterations = 0;
  std::int64_t factorisations = 0;

  // Residual of a state as it is now, and whether it is accepted.
  bool measure(const ContactProblem& problem, const SolverSettings& settings, ContactState& state) {
    residual = quicksand::residual(problem, state);
    converged = settings.accepts(residual);
    return converged;
  }
  // Takes over the outcome of a further solution and sums up the work.
  void add(const SolveReport& further) {
    converged = further.converged;
    stage = further.stage;
    residual = further.residual;
    velocity_change = further.velocity_change;
    add_work(further);
  }
  void add_work(const SolveReport& further) {
    iterations += further.iterations;
    factorisations += further.factorisations;
  }
};

}  // namespace quicksand
