#include "core/solvers/contact_solver.h"

#include <array>
#include <span>

#include "core/interior_point/interior_point.h"
#include "core/problem/residual.h"
#include "core/problem/rest.h"
#include "core/solvers/local.h"
#include "core/sweeps/gauss_seidel.h"

namespace quicksand {

struct ContactSolver::Methods {
  explicit Methods(WorkClock* told) : clock(told), interior_point(told) {}
  WorkClock* clock;
  LocalSolver local;
  InteriorPoint interior_point;
  std::vector<Vec3> warm_start;  // (nc)
  ContactState best;
};

ContactSolver::ContactSolver(WorkClock* clock) : methods_(std::make_unique<Methods>(clock)) {}
ContactSolver::~ContactSolver() = default;

namespace {

// The fallback chain:
//   1. the local solver, which also takes the warm start as it is if that solves the problem already
//      (a packing at rest);
//   2. interior point from near the warm start, and relaxation from where it jams;
//   3. both again from farther inside;
//   4. where that is all that is left to try (see protocol.cpp), both again from other distances and shares of the warm start.
// In a jammed packing the interior point ends at folds of its path, where some ten to some hundred sweeps
// of relaxation gain the last factor of 10 to 30. What has jammed is a bad start for another path: each
// begins at the warm start, and ends elsewhere. If all fall short, the best state counts, and the
// step is repeated with half the time step (see protocol.h).
template <class Methods>
SolveReport run_chain(const ContactProblem& problem, const SolverSettings& settings,
                      SolverStage from, Methods& methods, ContactState& state) {
  // Share of the warm start that a path starts from, and how far inside. In the shortest steps of a shock
  // through thousands of jammed contacts about two in five of the far ones end, and which ones is chance.
  struct Start {
    double share, shift;
  };
  constexpr std::array<Start, 6> kStarts{
      {{1, 1}, {1, 100}, {1, 10}, {0.5, 100}, {0, 100}, {0.9, 10}}};
  constexpr std::size_t kImpatientStarts = 2;
  // So many sweeps of relaxation; whoever is patient goes on while the distance falls below this share of
  // what it was. Under a piston most jams that ever end do so within 300, and half a step is cheaper than more.
  constexpr int kPolishSweeps = 300, kPatientSweeps = 1000;
  constexpr double kPatientGain = 0.98;
  SolveReport report;
  if (from > SolverStage::local) {
    const WorkClock::Span span(methods.clock, Work::residual);
    report.residual = residual(problem, state);
    report.converged = taken_as_it_is(problem, settings, report.residual, state);
  } else {
    const WorkClock::Span span(methods.clock, Work::local_solver);
    report = methods.local.solve(problem, settings, state);
  }
  if (report.converged) return report;
  methods.warm_start = state.impulse;
  methods.best = state;
  Residual least = report.residual;
  std::optional<double> change_of_best = report.velocity_change;
  // Settings for a part of the work; all parts together keep to the scene's.
  const auto sweeps_left = [&](std::int64_t most) {
    SolverSettings part = settings;
    const std::int64_t left = settings.max_iterations - report.iterations;
    part.max_iterations = static_cast<int>(std::clamp<std::int64_t>(left, 0, most));
    return part;
  };
  for (const auto& [share, shift] :
       std::span(kStarts).first(settings.patient ? kStarts.size() : kImpatientStarts)) {
    state.impulse = methods.warm_start;
    for (Vec3& p : state.impulse) p *= share;
    report.add(
        methods.interior_point.solve(problem, sweeps_left(settings.max_iterations), shift, state));
    if (report.converged) return report;
    double before = 0;
    do {
      before = settings.distance(report.residual);
      const int most = settings.patient ? kPatientSweeps : kPolishSweeps;
      report.add(methods.interior_point.relax(problem, sweeps_left(most), state));
      if (report.converged) return report;
    } while (settings.patient && settings.distance(report.residual) < kPatientGain * before);
    if (settings.distance(report.residual) > settings.distance(least)) continue;
    least = report.residual;
    change_of_best = report.velocity_change;
    methods.best = state;
  }
  state = methods.best;
  report.residual = least;
  report.velocity_change = change_of_best;
  return report;
}

}  // namespace

SolveReport ContactSolver::solve(const ContactProblem& problem, const SolverSettings& settings,
                                 ContactState& state, SolverStage from) {
  if (watch_) watch_({problem, settings, state.impulse, from});
  const SolveReport report = by_method(problem, settings, state, from);
  if (methods_->clock == nullptr) return report;
  WorkClock::Counts& counts = methods_->clock->counts;
  ++counts.solutions;
  ++counts.by_stage.at(static_cast<std::size_t>(report.stage));
  if (!report.converged) ++counts.not_converged;
  return report;
}

SolveReport ContactSolver::by_method(const ContactProblem& problem, const SolverSettings& settings,
                                     ContactState& state, SolverStage from) {
  switch (settings.method) {
    case Method::automatic:
      return run_chain(problem, settings, from, *methods_, state);
    case Method::interior_point:
      return methods_->interior_point.solve(problem, settings, 1, state);
    case Method::gauss_seidel: {
      const WorkClock::Span span(methods_->clock, Work::sweeps);
      return solve_gauss_seidel(problem, settings, state, methods_->clock);
    }
  }
  return {};
}

}  // namespace quicksand
