#include "core/solver.h"

#include "core/solve_gauss_seidel.h"
#include "core/solve_interior_point.h"
#include "core/solve_local.h"

namespace quicksand {

struct ContactSolver::Methods {
  LocalSolver local;
  InteriorPoint interior_point;
};

ContactSolver::ContactSolver() : methods_(std::make_unique<Methods>()) {}
ContactSolver::~ContactSolver() = default;

namespace {

// The ladder:
//   1. locality, which also takes the inherited impulses as they are if they solve the problem already
//      (a packing at rest);
//   2. interior point from near the inherited impulses, and Gauss-Seidel sweeps from where it jams;
//   3. both again from farther inside.
// In a jammed packing the interior point ends at folds of its path, where a few hundred sweeps still
// gain a factor of 20 to 30 and more sweeps gain little. What has jammed is a bad start for another
// path: each begins at the inherited impulses, and ends elsewhere. If all fall short, the best state
// counts, and the step is repeated with half the time step (see protocols.h).
SolveReport climb(const ContactProblem& problem, const SolverSettings& settings, LocalSolver& local,
                  InteriorPoint& interior_point, ContactState& state) {
  constexpr double kNearShift = 1, kFarShift = 10;
  constexpr int kPolishSweeps = 500;
  SolveReport report = local.solve(problem, settings, state);
  if (report.converged) return report;
  const std::vector<Vec3> inherited = state.impulse;
  SolverSettings polish = settings;
  polish.max_iterations = std::min(kPolishSweeps, settings.max_iterations);
  ContactState best = state;
  Residual least = report.residual;
  for (const double shift : {kNearShift, kFarShift}) {
    state.impulse = inherited;
    report.add(interior_point.solve(problem, settings, shift, state));
    if (!report.converged) report.add(solve_gauss_seidel(problem, polish, state));
    if (report.converged) return report;
    if (settings.distance(report.residual) > settings.distance(least)) continue;
    least = report.residual;
    best = state;
  }
  state = best;
  report.residual = least;
  return report;
}

}  // namespace

SolveReport ContactSolver::solve(const ContactProblem& problem, const SolverSettings& settings,
                                 ContactState& state) {
  switch (settings.method) {
    case Method::automatic:
      return climb(problem, settings, methods_->local, methods_->interior_point, state);
    case Method::interior_point:
      return methods_->interior_point.solve(problem, settings, 1, state);
    case Method::gauss_seidel:
      return solve_gauss_seidel(problem, settings, state);
  }
  return {};
}

}  // namespace quicksand
