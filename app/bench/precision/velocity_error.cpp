#include "app/bench/precision/velocity_error.h"

#include <algorithm>

#include "core/interior_point/newton_on_modes.h"
#include "core/problem/residual.h"
#include "core/problem/solver_settings.h"
#include "core/solvers/contact_solver.h"

namespace quicksand::bench {

namespace {

constexpr double kReferenceTolerance = 1e-12;
constexpr int kReferenceFactorisations = 150;
constexpr int kReferenceIterations = 40;

// A row for a solution with this outcome.
Row row_of(const StepProblem& step, const SolveReport& report, const ContactState& state,
           const Reference& reference) {
  Row run;
  run.size = mobile_disks(step.problem);
  run.contacts = static_cast<std::int64_t>(step.problem.contacts.size());
  run.iterations = report.iterations;
  run.factorisations = report.factorisations;
  run.residual = report.residual.natural;
  run.gap_error = kGapUnit * report.residual.gap;
  run.error = velocity_distance(step.problem, state.velocity, reference.velocity);
  return run;
}

}  // namespace

double velocity_distance(const ContactProblem& problem, const std::vector<Vec3>& v,
                         const std::vector<Vec3>& w) {
  double worst = 0;
  for (std::size_t i = 0; i < v.size(); ++i)
    worst = std::max(worst, (v[i] - w[i]).head<2>().norm());
  return worst / problem.dt;
}

Reference solve_tightly(const StepProblem& step) {
  const SolverSettings tight{.tolerance = kReferenceTolerance,
                             .max_factorisations = kReferenceFactorisations};
  ContactState first{.velocity = {}, .impulse = step.start};
  solve(step.problem, tight, first);
  ContactState second{.velocity = {}, .impulse = step.no_force};
  for (Vec3& p : second.impulse) p *= 2;
  solve(step.problem, tight, second);
  ContactMatrix matrix;
  matrix.attach(step.problem);
  NewtonOnModes().solve(step.problem, tight, kReferenceIterations, matrix, second);
  Reference reference;
  reference.doubt = velocity_distance(step.problem, first.velocity, second.velocity);
  const Residual of_first = residual(step.problem, first);
  reference.residual = residual(step.problem, second);
  reference.velocity = second.velocity;
  if (of_first.natural < reference.residual.natural) {
    reference.residual = of_first;
    reference.velocity = first.velocity;
  }
  return reference;
}

Row measure_solution(const StepProblem& step, const std::vector<Vec3>& start,
                     const SolverSettings& settings, const Reference& reference,
                     const Options& options) {
  ContactState state{.velocity = {}, .impulse = start};
  const Stopwatch watch;
  const SolveReport report = solve(step.problem, settings, state);
  const Seconds seconds = watch.elapsed();
  Row run = row_of(step, report, state, reference);
  run.what = "solve";
  run.method = options.method;
  run.tolerance = settings.tolerance;
  run.seconds = seconds;
  run.unconverged = report.converged ? 0 : 1;
  return run;
}

Row measure_gauss_seidel(const StepProblem& step, const std::vector<Vec3>& start, double error,
                         const Reference& reference, const Options& options) {
  constexpr int kLeastPortion = 20;
  ContactState state{.velocity = {}, .impulse = start};
  SolverSettings settings{.method = Method::gauss_seidel, .tolerance = 0, .max_iterations = 0};
  SolveReport report;
  Seconds seconds;
  double reached = 0;
  do {
    const Stopwatch watch;
    report.add(solve(step.problem, settings, state));
    seconds += watch.elapsed();
    reached = velocity_distance(step.problem, state.velocity, reference.velocity);
    settings.max_iterations = std::max(kLeastPortion, static_cast<int>(report.iterations / 10));
  } while (reached > error && seconds.cpu < options.patience());
  Row run = row_of(step, report, state, reference);
  run.what = "gauss_seidel";
  run.method = "gauss_seidel";
  run.seconds = seconds;
  run.unconverged = reached > error ? 1 : 0;
  return run;
}

}  // namespace quicksand::bench
