#include "core/solver.h"

#include "core/residual.h"
#include "core/solve_gauss_seidel.h"
#include "core/solve_interior_point.h"
#include "core/solve_local.h"

namespace quicksand {

struct ContactSolver::Methods {
  LocalSolver local;
  InteriorPoint interior_point;
  std::vector<Vec3> inherited;  // (nc)
  ContactState best;
};

ContactSolver::ContactSolver() : methods_(std::make_unique<Methods>()) {}
ContactSolver::~ContactSolver() = default;

namespace {

// The ladder:
//   1. locality, which also takes the inherited impulses as they are if they solve the problem already
//      (a packing at rest);
//   2. interior point from near the inherited impulses, and Gauss-Seidel sweeps from where it jams;
//   3. both again from farther inside.
// In a jammed packing the interior point ends at folds of its path, where some hundred sweeps still
// gain a factor of 20 to 30, the more of them the larger the packing. What has jammed is a bad start
// for another path: each begins at the inherited impulses, and ends elsewhere. If all fall short, the
// best state counts, and the step is repeated with half the time step (see protocols.h).
template <class Methods>
SolveReport climb(const ContactProblem& problem, const SolverSettings& settings, Rung from,
                  Methods& methods, ContactState& state) {
  constexpr double kNearShift = 1, kFarShift = 100;
  // So many sweeps at once, and again while the distance falls below this share of what it was. Patience
  // pays: of a jammed piston run, steps that no halving repaired at 0.7 need no halving at 0.98.
  constexpr std::int64_t kPolishSweeps = 1000;
  constexpr double kPolishGain = 0.98;
  SolveReport report;
  if (from > Rung::locality) {
    report.residual = residual(problem, state);
    report.converged = settings.distance(report.residual) <= SolverSettings::kAsItIs;
  } else {
    report = methods.local.solve(problem, settings, state);
  }
  if (report.converged) return report;
  methods.inherited = state.impulse;
  methods.best = state;
  Residual least = report.residual;
  for (const double shift : {kNearShift, kFarShift}) {
    state.impulse = methods.inherited;
    report.add(methods.interior_point.solve(problem, settings, shift, state));
    if (report.converged) return report;
    double before = 0;
    do {
      SolverSettings polish = settings;
      polish.max_iterations =
          static_cast<int>(std::min(kPolishSweeps, settings.max_iterations - report.iterations));
      before = settings.distance(report.residual);
      report.add(solve_gauss_seidel(problem, polish, state));
      if (report.converged) return report;
    } while (settings.distance(report.residual) < kPolishGain * before);
    if (settings.distance(report.residual) > settings.distance(least)) continue;
    least = report.residual;
    methods.best = state;
  }
  state = methods.best;
  report.residual = least;
  return report;
}

}  // namespace

SolveReport ContactSolver::solve(const ContactProblem& problem, const SolverSettings& settings,
                                 ContactState& state, Rung from) {
  switch (settings.method) {
    case Method::automatic:
      return climb(problem, settings, from, *methods_, state);
    case Method::interior_point:
      return methods_->interior_point.solve(problem, settings, 1, state);
    case Method::gauss_seidel:
      return solve_gauss_seidel(problem, settings, state);
  }
  return {};
}

}  // namespace quicksand
