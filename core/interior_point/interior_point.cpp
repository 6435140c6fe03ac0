#include "core/interior_point/interior_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/interior_point/path_tuning.h"
#include "core/problem/delassus.h"
#include "core/problem/projection.h"
#include "core/problem/residual.h"

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

// H velocity at a contact.
Vec3 contact_velocity(const ContactRow& row, const std::vector<Vec3>& velocity) {
  return relative_velocity(row, velocity[row.a], velocity[row.b]);
}

// Speed by which impulse p at relative velocity u is away from the laws.
double violation(const ContactRow& row, const Vec3& delassus, int components, const Vec3& p,
                 const Vec3& u) {
  Vec3 q = p;
  for (int k = 0; k < 3; ++k)
    if (delassus[k] > 0) q[k] -= u[k] / delassus[k];
  const Vec3 off = natural_map(row, components, p, q).cwiseAbs().cwiseProduct(delassus);
  return std::max({off.x(), off.y(), off.z() * row.arm});
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
  SolveReport report = {};
  double product = 0;        // mean of the pairs, before the last step
  double least_product = 0;  // no smaller one is aimed at
  double most_proximal = 0;  // beyond a fold
  double best = 0;           // least distance from acceptance
  double tried = kInfinity;  // distance at which a few sweeps were last tried
  int settling = 0;          // iterations since acceptance
  Jam jam = {};

  void measure() {
    report.residual = residual(problem, state);
    report.converged = settings.accepts(report.residual);
  }
};

// The smallest product of an admissible error of an impulse and one of a speed.
double InteriorPoint::admissible_product(const ContactProblem& problem,
                                         const SolverSettings& settings) const {
  const double admissible = settings.tolerance * problem.force_scale * problem.dt;
  double least = kInfinity;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    double softest = delassus_[c].x();
    if (cone_[c].slide.limit > 0) softest = std::min(softest, delassus_[c].y());
    if (cone_[c].roll.limit > 0) softest = std::min(softest, delassus_[c].z() * row.arm * row.arm);
    least = std::min({least, admissible * softest, row.gap_tolerance / problem.dt});
  }
  return admissible * least;
}

void InteriorPoint::start(const ContactProblem& problem, double shift, const ContactState& state) {
  const std::size_t nc = problem.contacts.size();
  proximal_ = T::kProximal;
  delassus_.resize(nc);
  cone_.assign(nc, {});
  impedance_.resize(nc);
  impulse_.resize(nc);

  velocity_from_impulses(problem, state.impulse, velocity_);
  double worst = 0;
  for (std::size_t c = 0; c < nc; ++c) {
    const ContactRow& row = problem.contacts[c];
    delassus_[c] = delassus_diagonal(row, problem.inverse_mass[row.a], problem.inverse_mass[row.b]);
    worst = std::max(worst, violation(row, delassus_[c], problem.components, state.impulse[c],
                                      row.offset + contact_velocity(row, velocity_)));
  }
  const double least_speed = std::max(shift * worst, 1e-12);
  for (std::size_t c = 0; c < nc; ++c) {
    const ContactRow& row = problem.contacts[c];
    ContactCone& cone = cone_[c];
    if (problem.components >= 2 && delassus_[c].y() > 0) cone.slide.limit = row.friction;
    if (problem.components >= 3 && delassus_[c].z() > 0) cone.roll.limit = row.rolling;
    const Vec3 u = row.offset + contact_velocity(row, velocity_);
    cone.start(state.impulse[c], u, least_speed / delassus_[c].x(), least_speed);
    impulse_[c] = cone.impulse();
  }
  velocity_from_impulses(problem, impulse_, velocity_);
}

void InteriorPoint::linearise(const ContactProblem& problem) {
  products_ =
      gather_range<Products>(cone_.size(), [&](std::size_t begin, std::size_t end, Products& part) {
        for (std::size_t c = begin; c < end; ++c) {
          const ContactRow& row = problem.contacts[c];
          const Vec3 u = row.offset + contact_velocity(row, velocity_);
          impedance_[c] = cone_[c].linearise(u, proximal_ * delassus_[c]);
          cone_[c].visit_pairs([&](double x, double, double y, double) {
            part.by_power[0] += x * y;
            ++part.pairs;
          });
        }
      });
  matrix_.factorise(impedance_);
}

double InteriorPoint::find_direction(const ContactProblem& problem, double tau, bool correct) {
  share_range(cone_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) impulse_[c] = cone_[c].set_targets(tau, correct);
  });
  return follow(problem);
}

double InteriorPoint::centre_direction(const ContactProblem& problem, double tau, double alpha) {
  const double foreseen = std::min(1.0, alpha + T::kFurther);
  const auto further = [&](double x, double dx, double y, double dy) {
    const double product = (x + foreseen * dx) * (y + foreseen * dy);
    const double wanted = std::clamp(product, T::kLeastOfAim * tau, T::kMostOfAim * tau);
    return std::max(wanted - product, -T::kMostOfAim * tau);
  };
  share_range(cone_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) impulse_[c] = cone_[c].adjust_targets(further);
  });
  return follow(problem);
}

double InteriorPoint::follow(const ContactProblem& problem) {
  matrix_.velocity_change(impulse_, change_);
  const Products found =
      gather_range<Products>(cone_.size(), [&](std::size_t begin, std::size_t end, Products& part) {
        for (std::size_t c = begin; c < end; ++c) {
          cone_[c].find_direction(contact_velocity(problem.contacts[c], change_));
          cone_[c].visit_pairs([&](double x, double dx, double y, double dy) {
            if (-dx > part.fastest * x) part.fastest = -dx / x;
            if (-dy > part.fastest * y) part.fastest = -dy / y;
            part.by_power[1] += x * dy + y * dx;
            part.by_power[2] += dx * dy;
          });
        }
      });
  products_.by_power[1] = found.by_power[1];
  products_.by_power[2] = found.by_power[2];
  return 1 / found.fastest;
}

double InteriorPoint::mean_product(double alpha) const {
  const std::array<double, 3>& p = products_.by_power;
  const double sum = p[0] + alpha * (p[1] + alpha * p[2]);
  return products_.pairs > 0 ? sum / static_cast<double>(products_.pairs) : 0;
}

// Finds the next direction along the path, and how far to go.
double InteriorPoint::find_step(const ContactProblem& problem, double product,
                                double least_product) {
  const auto length = [](double longest) { return std::min(1.0, T::kBoundaryShare * longest); };
  if (matrix_.negative()) return length(find_direction(problem, T::kGrowth * product, false));
  const double affine = mean_product(std::min(1.0, find_direction(problem, 0, false)));
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
  SolveReport report = solve_relaxation(problem, settings, state, relaxation_);
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
  share_range(cone_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      cone_[c].move(alpha);
      cone_[c].lift(T::kLeastShare * path.product);
      impulse_[c] = cone_[c].impulse();
      path.state.impulse[c] = cone_[c].admissible_impulse(delassus_[c].x());
    }
  });
  // The velocity is taken from the impulses and not summed up, so that the two cannot part.
  velocity_from_impulses(problem, impulse_, velocity_);
  path.measure();
  path.report.velocity_change = fastest_at_contacts(problem, change_) / problem.velocity_scale;
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
      distance < std::min(T::kNear, T::kNearer * path.tried)) {
    path.tried = distance;
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
  Path path{.problem = problem, .settings = settings, .state = state};
  SolveReport& report = path.report;
  // The start counts: what is handed on is never worse than what came in.
  path.measure();
  path.best = settings.distance(report.residual);
  if (path.best <= SolverSettings::kAsItIs) return report;
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
