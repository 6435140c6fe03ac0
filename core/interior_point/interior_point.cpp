#include "core/interior_point/interior_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/interior_point/path_tuning.h"
#include "core/problem/rest.h"

namespace quicksand {

namespace {

using T = PathTuning;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What is not known has not settled.
double speed_of_change(const SolveReport& report) {
  return report.velocity_change.value_or(kInfinity);
}

bool have_settled(const SolveReport& report, const SolverSettings& settings) {
  return speed_of_change(report) <= settings.velocity_tolerance;
}

}  // namespace

// One solution under way.
struct InteriorPoint::Path {
  const ContactProblem& problem;
  const SolverSettings& settings;
  ContactState& state;
  WorkClock* clock = nullptr;
  SolveReport report = {};
  double product = 0;  // mean of the pairs, before the last step
  double proximal_at_fold = 0;
  double best = 0;   // least distance from acceptance
  int settling = 0;  // iterations since acceptance

  void measure() {
    const WorkClock::Span span(clock, Work::residual);
    report.measure(problem, settings, state);
  }
};

// Finds the next direction along the path, and how far to go.
double InteriorPoint::find_step(const ContactProblem& problem, double product) {
  const auto length = [](double longest) { return std::min(1.0, T::kBoundaryShare * longest); };
  if (matrix_.negative()) return length(find_direction(problem, T::kGrowth * product, false));
  const double affine = mean_product(std::min(1.0, follow(problem)));
  const double centring = std::pow(std::max(0.0, affine / product), 3);
  const double aim = centring * product;
  double alpha = length(find_direction(problem, aim, true));
  if (alpha < T::kLongStep) alpha = length(centre_direction(problem, aim, alpha));
  if (alpha >= T::kShortStep) return alpha;
  return length(find_direction(problem, T::kAlignedShare * product, false));
}

bool InteriorPoint::finish(const ContactProblem& problem, const SolverSettings& settings,
                           ContactState& state, SolveReport& report) {
  const SolveReport end = newton_.solve(problem, settings, T::kNewtonSteps, matrix_, state);
  report.residual = end.residual;
  report.velocity_change = std::min(speed_of_change(report), speed_of_change(end));
  report.factorisations += end.factorisations;
  return have_settled(report, settings);
}

SolveReport InteriorPoint::relax(const ContactProblem& problem, const SolverSettings& settings,
                                 ContactState& state) {
  WorkClock::look_up(clock_);
  SolveReport report;
  {
    const WorkClock::Span span(clock_, Work::sweeps);
    report = solve_relaxation(problem, settings, state, relaxation_);
  }
  if (!report.converged) return report;
  matrix_.attach(problem);
  finish(problem, settings, state, report);
  return report;
}

// Moves along the path by one step; leaves the admissible impulses of its end in the state, and their residual.
void InteriorPoint::iterate(Path& path) {
  const ContactProblem& problem = path.problem;
  linearise(problem, T::kProximal);
  ++path.report.factorisations;
  if (matrix_.negative() && path.proximal_at_fold > T::kProximal) {
    linearise(problem, path.proximal_at_fold);
    ++path.report.factorisations;
  }
  path.product = mean_product(0);
  const double alpha = find_step(problem, path.product);
  const std::size_t nc = problem.contacts.size();
  for_lane_blocks(
      nc, [&](std::size_t k) __attribute__((always_inline)) {
        cone_[k].move(alpha);
        Components<Lanes> p;
        cone_[k].impulse(p);
        matrix_.rows()[k].momenta(p, matrix_.momenta(k));
        cone_[k].admissible_impulse(softness_[k].n, impulse_[k]);
      });
  // The velocity is taken from the impulses and not summed up, so that the two cannot part.
  matrix_.velocity(velocity_);
  for (std::size_t c = 0; c < nc; ++c) {
    const Components<Lanes>& p = impulse_[c / kLanes];
    const std::size_t k = c % kLanes;
    path.state.impulse[static_cast<std::size_t>(matrix_.order()[c])] = {p.n[k], p.t[k], p.r[k]};
  }
  path.measure();
  path.report.velocity_change = matrix_.fastest_change() / problem.velocity_scale;
}

// Whether the state is the solution: its residual is accepted, and its velocities have settled or no longer do.
bool InteriorPoint::accept(Path& path) {
  SolveReport& report = path.report;
  if (!report.converged) return false;
  const bool last = have_settled(report, path.settings) || ++path.settling > T::kSettling;
  const bool finishes =
      (last || path.settling == 1) && finish(path.problem, path.settings, path.state, report);
  return last || finishes;
}

// Whether a few sweeps of relaxation decide the contacts that the path leaves undecided.
bool InteriorPoint::rescue(Path& path) {
  SolveReport& report = path.report;
  const double distance = path.settings.distance(report.residual);
  if (have_settled(report, path.settings) && report.factorisations >= T::kLongPath &&
      distance < T::kNear) {
    const WorkClock::Span span(clock_, Work::sweeps);
    SolverSettings few = path.settings;
    few.max_iterations = static_cast<int>(
        std::min<std::int64_t>(T::kFewSweeps, few.max_iterations - report.iterations));
    relaxed_.impulse = path.state.impulse;
    const SolveReport relaxed = solve_relaxation(path.problem, few, relaxed_, relaxation_);
    report.iterations += relaxed.iterations;
    if (relaxed.converged) {
      path.state = relaxed_;
      report.converged = true;
      report.residual = relaxed.residual;
      return true;
    }
  }
  if (distance < path.best) {
    path.best = distance;
    best_ = path.state.impulse;
  }
  return false;
}

SolveReport InteriorPoint::solve(const ContactProblem& problem, const SolverSettings& settings,
                                 double shift, ContactState& state) {
  const WorkClock::Span span(clock_, Work::cones);
  Path path{.problem = problem, .settings = settings, .state = state, .clock = clock_};
  SolveReport& report = path.report;
  // The start counts: what is handed on is never worse than what came in.
  path.measure();
  path.best = settings.distance(report.residual);
  if (taken_as_it_is(problem, settings, report.residual, state)) return report;
  matrix_.attach(problem);
  if (report.converged && finish(problem, settings, state, report)) return report;
  start(problem, shift, state);
  path.best = settings.distance(report.residual);
  best_ = state.impulse;
  path.proximal_at_fold = shift > 1 ? T::kProximal : T::kProximalAtFolds;
  report.stage = shift > 1 ? SolverStage::far_start : SolverStage::interior_point;
  while (report.factorisations < settings.max_factorisations) {
    iterate(path);
    if (accept(path)) return report;
    if (!std::isfinite(path.product)) break;
    if (rescue(path)) return report;
  }
  state.impulse = best_;
  report.velocity_change.reset();  // that of the last iterate is of another state
  path.measure();
  return report;
}

}  // namespace quicksand
