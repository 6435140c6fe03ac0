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

// Whether velocities have settled so far that relaxation, which leaves long waves, may end a solution.
bool have_settled(const SolveReport& report, const SolverSettings& settings) {
  return speed_of_change(report) <= T::kSettledShare * settings.velocity_tolerance;
}

}  // namespace

// One solution under way.
struct InteriorPoint::Path {
  // Whether the path has jammed.
  class Jam {
   public:
    // Told after each iteration, with the least distance before it. Says so once for each gain of the best.
    bool met(double distance, double least, std::int64_t factorisations) {
      if (distance < T::kGain * gained_) {
        gained_ = distance;
        gained_at_ = factorisations;
        return false;
      }
      if (least >= T::kNear || least >= T::kGain * met_at_ ||
          factorisations - gained_at_ < T::kPatience)
        return false;
      met_at_ = least;
      return true;
    }

   private:
    double gained_ = kInfinity, met_at_ = gained_;
    std::int64_t gained_at_ = 0;
  };

  const ContactProblem& problem;
  const SolverSettings& settings;
  ContactState& state;
  WorkClock* clock = nullptr;
  SolveReport report = {};
  double product = 0;        // mean of the pairs, before the last step
  double least_product = 0;  // no smaller one is aimed at
  double most_proximal = 0;  // beyond a fold
  double best = 0;           // least distance from acceptance
  int settling = 0;          // iterations since acceptance
  Jam jam = {};

  void measure() {
    const WorkClock::Span span(clock, Work::residual);
    report.measure(problem, settings, state);
  }
};

// Finds the next direction along the path, and how far to go.
double InteriorPoint::find_step(const ContactProblem& problem, double product,
                                double least_product) {
  const auto length = [](double longest) { return std::min(1.0, T::kBoundaryShare * longest); };
  if (matrix_.negative()) return length(find_direction(problem, T::kGrowth * product, false));
  const double affine = mean_product(std::min(1.0, follow(problem)));
  const double centring = std::pow(std::max(0.0, affine / product), 3);
  const double aim = std::max(centring * product, least_product);
  double alpha = length(find_direction(problem, aim, true));
  if (alpha < T::kLongStep) alpha = length(centre_direction(problem, aim, alpha));
  if (alpha >= T::kShortStep) return alpha;
  return length(
      find_direction(problem, std::max(T::kAlignedShare * product, least_product), false));
}

bool InteriorPoint::finish(const ContactProblem& problem, const SolverSettings& settings,
                           ContactState& state, SolveReport& report) {
  const bool settled = speed_of_change(report) <= settings.velocity_tolerance;
  const SolveReport end =
      newton_.solve(problem, settings, settled ? T::kFinishing : T::kSearching, matrix_, state);
  report.residual = end.residual;
  report.velocity_change = std::min(speed_of_change(report), speed_of_change(end));
  report.factorisations += end.factorisations;
  return *report.velocity_change <= settings.velocity_tolerance;
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

bool InteriorPoint::try_relaxation(Path& path, int sweeps) {
  const ContactProblem& problem = path.problem;
  const SolverSettings& settings = path.settings;
  SolveReport& report = path.report;
  SolverSettings few = settings;
  few.max_iterations =
      static_cast<int>(std::min<std::int64_t>(sweeps, settings.max_iterations - report.iterations));
  // Newton's method on modes that relaxation has decided gains nothing where velocities have settled.
  const bool settled = have_settled(report, settings);
  const WorkClock::Span span(clock_, Work::sweeps);
  SolveReport relaxed = settled ? solve_relaxation(problem, few, relaxed_, relaxation_)
                                : relax(problem, few, relaxed_);
  if (settled) relaxed.velocity_change = report.velocity_change;
  report.iterations += relaxed.iterations;
  report.factorisations += relaxed.factorisations;
  if (!relaxed.converged) return false;
  path.state = relaxed_;
  report.converged = true;
  report.residual = relaxed.residual;
  report.velocity_change = relaxed.velocity_change;
  return true;
}

// Moves along the path by one step; leaves the admissible impulses of its end in the state, and their residual.
void InteriorPoint::iterate(Path& path) {
  const ContactProblem& problem = path.problem;
  linearise(problem);
  ++path.report.factorisations;
  if (matrix_.negative() && proximal_ < path.most_proximal) {
    proximal_ = path.most_proximal;
    linearise(problem);
    ++path.report.factorisations;
  } else {
    proximal_ = std::max(T::kProximal, T::kProximalDecay * proximal_);
  }
  path.product = mean_product(0);
  const double alpha = find_step(problem, path.product, path.least_product);
  const std::size_t nc = problem.contacts.size();
  for_lane_blocks(
      nc, [&](std::size_t k) __attribute__((always_inline)) {
        cone_[k].move(alpha);
        cone_[k].lift(T::kLeastShare * path.product);
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
  const bool last =
      speed_of_change(report) <= path.settings.velocity_tolerance || ++path.settling > T::kSettling;
  const bool finishes =
      (last || path.settling == 1) && finish(path.problem, path.settings, path.state, report);
  return last || finishes;
}

// Whether relaxation ends what the path does not: some contacts still undecided, or a jam.
bool InteriorPoint::rescue(Path& path) {
  const SolveReport& report = path.report;
  const double distance = path.settings.distance(report.residual);
  if (have_settled(report, path.settings) && report.factorisations >= T::kLongPath &&
      distance < T::kNear) {
    relaxed_.impulse = path.state.impulse;
    if (try_relaxation(path, T::kFewSweeps)) return true;
  }
  if (speed_of_change(report) <= path.settings.velocity_tolerance &&
      path.jam.met(distance, path.best, report.factorisations)) {
    relaxed_.impulse = best_;
    if (try_relaxation(path, T::kTrySweeps)) return true;
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
  path.least_product = T::kLeastProduct * admissible_product(problem, settings);
  path.most_proximal = shift > 1 ? T::kProximal : T::kProximalAtFolds;
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
