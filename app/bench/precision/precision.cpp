// Work against precision of one step: for every solver, the time to each residual and the velocity
// error that it has there.
#include <algorithm>
#include <cmath>

#include "app/bench/precision/precision_problems.h"
#include "app/bench/precision/velocity_error.h"
#include "app/bench/statistics.h"
#include "core/problem/residual.h"
#include "core/problem/solver_settings.h"
#include "core/solvers/contact_solver.h"

namespace quicksand::bench {

namespace {

constexpr int kLoosest = -2, kTightest = -12;  // decades of the residual
constexpr double kMeasured = 0.02;             // a measurement is repeated for this long ... [s]
constexpr int kMostRepeats = 50, kRepeats = 3;

double decade(int k) { return std::pow(10.0, k); }

// The median of the repeats; what a solver finds is the same in all.
Row measured(const StepProblem& step, const SolverSettings& settings, const Reference& reference,
             const Options& options) {
  Row row;
  std::vector<double> cpu, wall;
  double spent = 0;
  const int least = options.repeats_or(kRepeats);
  while (static_cast<int>(cpu.size()) < least ||
         (spent < kMeasured && static_cast<int>(cpu.size()) < kMostRepeats)) {
    stop_if_interrupted();
    row = measure_solution(step, step.start, settings, reference, options);
    cpu.push_back(row.seconds.cpu);
    wall.push_back(row.seconds.wall);
    spent += row.seconds.wall;
    if (spent > options.patience()) break;
  }
  row.seconds = {median(cpu), median(wall)};
  return row;
}

// Ends with the first residual that is not reached: its row holds the floor.
void measure_direct(Method method, const char* word, const StepProblem& step,
                    const Reference& reference, const Options& options, std::vector<Row>& rows) {
  for (int k = kLoosest; k >= kTightest; --k) {
    const SolverSettings settings{.method = method, .tolerance = decade(k)};
    Row row = measured(step, settings, reference, options);
    row.what = row.unconverged == 0 ? "to residual" : "floor";
    row.method = word;
    row.dt = step.problem.dt;
    rows.push_back(row);
    if (row.unconverged > 0) break;
  }
}

// One sequence of sweeps, checked after each tenth more of those done; the checks are not timed.
void measure_sweeps(const StepProblem& step, const Reference& reference, const Options& options,
                    std::vector<Row>& rows) {
  constexpr int kLeastPortion = 5;
  ContactState state{.velocity = {}, .impulse = step.start};
  SolverSettings settings{.method = Method::gauss_seidel, .tolerance = 0};
  Row row{.what = "to residual", .method = "gauss_seidel", .dt = step.problem.dt};
  row.size = mobile_disks(step.problem);
  row.contacts = static_cast<std::int64_t>(step.problem.contacts.size());
  int next = kLoosest;
  while (next >= kTightest) {
    stop_if_interrupted();
    settings.max_iterations = std::max(kLeastPortion, static_cast<int>(row.iterations / 10));
    const Stopwatch watch;
    row.iterations += solve(step.problem, settings, state).iterations;
    row.seconds += watch.elapsed();
    const Residual reached = residual(step.problem, state);
    row.residual = reached.natural;
    row.gap_error = kGapUnit * reached.gap;
    row.error = velocity_distance(step.problem, state.velocity, reference.velocity);
    for (; next >= kTightest && reached.natural <= decade(next); --next) {
      row.tolerance = decade(next);
      rows.push_back(row);
    }
    if (row.seconds.cpu > options.patience()) break;
  }
  if (next < kTightest) return;
  row.what = "floor";
  row.tolerance = decade(next);
  row.unconverged = 1;
  rows.push_back(row);
}

void measure_problem(const PrecisionProblem& problem, const Options& options,
                     std::vector<Row>& rows) {
  const StepProblem step = problem.make(options);
  const Reference reference = solve_tightly(step);
  rows.push_back({.what = "reference",
                  .size = mobile_disks(step.problem),
                  .contacts = static_cast<std::int64_t>(step.problem.contacts.size()),
                  .dt = step.problem.dt,
                  .residual = reference.residual.natural,
                  .error = reference.doubt,
                  .found = problem.what});
  measure_direct(Method::automatic, "auto", step, reference, options, rows);
  measure_direct(Method::interior_point, "interior_point", step, reference, options, rows);
  measure_sweeps(step, reference, options, rows);
}

}  // namespace

std::vector<Task> precision_tasks(const Options& options) {
  return tasks_of(precision_problems(), options, measure_problem);
}

}  // namespace quicksand::bench
