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

// The ladder, each rung from the best state of the one before:
//   1. interior point from the inherited impulses, which takes them as they are if they solve the
//      problem already (a packing at rest);
//   2. interior point from far inside, which forgets a bad start;
//   3. Gauss-Seidel sweeps as polish: in a jammed packing they still gain where the interior point
//      cannot, and cost less than a halved step.
// If all fall short, the step is repeated with half the time step (see protocols.h).
SolveReport climb(const ContactProblem& problem, const SolverSettings& settings, LocalSolver& local,
                  InteriorPoint& interior_point, ContactState& state) {
  constexpr double kNearShift = 1, kFarShift = 100;
  constexpr int kPolishSweeps = 3000;
  SolveReport report = local.solve(problem, settings, state);
  for (const double shift : {kNearShift, kFarShift}) {
    if (report.converged) return report;
    report.add(interior_point.solve(problem, settings, shift, state));
  }
  if (report.converged) return report;
  SolverSettings polish = settings;
  polish.max_iterations = std::min(kPolishSweeps, settings.max_iterations);
  report.add(solve_gauss_seidel(problem, polish, state));
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
