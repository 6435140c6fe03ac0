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

// In the order of the lanes.
double sum(const Lanes& x) { return (x[0] + x[1]) + (x[2] + x[3]); }

// What friction and rolling friction are bounded by, over N; 0 where they are not modelled.
Vec3 bounds_of(const ContactProblem& problem, const ContactRow& row, const Vec3& delassus) {
  return {0, problem.components >= 2 && delassus.y() > 0 ? row.friction : 0,
          problem.components >= 3 && delassus.z() > 0 ? row.rolling : 0};
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
  WorkClock* clock = nullptr;
  SolveReport report = {};
  double product = 0;        // mean of the pairs, before the last step
  double least_product = 0;  // no smaller one is aimed at
  double most_proximal = 0;  // beyond a fold
  double best = 0;           // least distance from acceptance
  double tried = kInfinity;  // distance at which a few sweeps were last tried
  int settling = 0;          // iterations since acceptance
  Jam jam = {};

  void measure() {
    const WorkClock::Span span(clock, Work::residual);
    report.residual = residual(problem, state);
    report.converged = settings.accepts(report.residual);
  }
};

void InteriorPoint::Products::add(const Products& other) {
  for (std::size_t k = 0; k < by_power.size(); ++k) by_power[k] += other.by_power[k];
  pairs += other.pairs;
  fastest = larger(fastest, other.fastest);
}

// The smallest product of an admissible error of an impulse and one of a speed.
double InteriorPoint::admissible_product(const ContactProblem& problem,
                                         const SolverSettings& settings) const {
  const double admissible = settings.tolerance * problem.force_scale * problem.dt;
  double least = kInfinity;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    const Vec3 bounds = bounds_of(problem, row, delassus_[c]);
    double softest = delassus_[c].x();
    if (bounds.y() > 0) softest = std::min(softest, delassus_[c].y());
    if (bounds.z() > 0) softest = std::min(softest, delassus_[c].z() * row.arm * row.arm);
    least = std::min({least, admissible * softest, row.gap_tolerance / problem.dt});
  }
  return admissible * least;
}

void InteriorPoint::start(const ContactProblem& problem, double shift, const ContactState& state) {
  const std::size_t nc = problem.contacts.size(), blocks = lane_blocks(nc);
  proximal_ = T::kProximal;
  delassus_.resize(nc);
  softness_.resize(blocks);
  cone_.resize(blocks);
  impedance_.resize(blocks);
  impulse_.resize(blocks);

  double worst = 0;
  for (std::size_t c = 0; c < nc; ++c) {
    const ContactRow& row = problem.contacts[c];
    delassus_[c] = delassus_diagonal(row, problem.inverse_mass[row.a], problem.inverse_mass[row.b]);
    const Vec3 u =
        row.offset + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
    worst = std::max(worst, violation(row, delassus_[c], problem.components, state.impulse[c], u));
  }
  const double least_speed = std::max(shift * worst, 1e-12);
  for (std::size_t c = 0; c < kLanes * blocks; ++c) {
    // A lane beyond the last contact has no pairs; what it starts from only has to be finite.
    const auto from = static_cast<std::size_t>(matrix_.order()[c < nc ? c : 0]);
    const std::size_t k = c % kLanes;
    const ContactRow& row = problem.contacts[from];
    const Vec3& p = state.impulse[from];
    const Vec3 bounds = bounds_of(problem, row, delassus_[from]);
    ContactCone<Lanes>& cone = cone_[c / kLanes];
    Components<Lanes>& w = softness_[c / kLanes];
    cone.here[k] = c < nc ? 1 : 0;
    cone.slide.limit[k] = c < nc ? bounds.y() : 0;
    cone.roll.limit[k] = c < nc ? bounds.z() : 0;
    w.n[k] = delassus_[from].x(), w.t[k] = delassus_[from].y(), w.r[k] = delassus_[from].z();
    impulse_[c / kLanes].n[k] = p.x();
    impulse_[c / kLanes].t[k] = p.y();
    impulse_[c / kLanes].r[k] = p.z();
  }
  set_momenta(nc);
  matrix_.velocity(velocity_);
  for_lane_blocks(nc, [&](std::size_t k) __attribute__((always_inline)) {
    Components<Lanes> u;
    relative_velocity_at(k, u);
    const Lanes least = Lanes{} + least_speed, least_n = least / softness_[k].n;
    cone_[k].start(impulse_[k], u, least_n, least);
    cone_[k].impulse(impulse_[k]);
  });
  set_momenta(nc);
  matrix_.velocity(velocity_);
}

// The square of the fastest change at a contact (see fastest_at_contacts).
double InteriorPoint::fastest_change(std::size_t contacts) const {
  struct alignas(sizeof(Lanes)) Fastest {
    Lanes squared{};
    void add(const Fastest& other) { squared = larger(squared, other.squared); }
  };
  const Fastest found = gather_lane_blocks<Fastest>(
      contacts, [&](std::size_t k, Fastest& part) __attribute__((always_inline)) {
        const RowLanes& row = matrix_.rows()[k];
        const auto at_contact = [&](const std::array<int, kLanes>& body, const Lanes& spin_n,
                                    const Lanes& spin_t) __attribute__((always_inline)) {
          BodyLanes v;
          gather(change_, body, v);
          const Lanes n = row.normal_x * v.x + row.normal_y * v.y + spin_n * v.z;
          const Lanes t = row.normal_x * v.y - row.normal_y * v.x + spin_t * v.z;
          part.squared = larger<Lanes>(part.squared, n * n + t * t);
        };
        at_contact(row.a, row.spin_a_n, row.spin_a_t);
        at_contact(row.b, row.spin_b_n, row.spin_b_t);
      });
  double squared = 0;
  for (std::size_t k = 0; k < kLanes; ++k) squared = std::max(squared, found.squared[k]);
  return squared;
}

// Momenta of the impulses.
void InteriorPoint::set_momenta(std::size_t contacts) {
  for_lane_blocks(contacts, [&](std::size_t k) __attribute__((always_inline)) {
    matrix_.rows()[k].momenta(impulse_[k], matrix_.momenta(k));
  });
}

// H velocity + offset of the impulses of the cones.
[[gnu::always_inline]] inline void InteriorPoint::relative_velocity_at(std::size_t block,
                                                                       Components<Lanes>& u) const {
  const RowLanes& row = matrix_.rows()[block];
  row.relative_velocity(velocity_, u);
  u.n += row.offset.n;
  u.t += row.offset.t;
  u.r += row.offset.r;
}

void InteriorPoint::linearise(const ContactProblem& problem) {
  const Products found = gather_lane_blocks<Products>(
      problem.contacts.size(), [&](std::size_t k, Products& part) __attribute__((always_inline)) {
        Components<Lanes> u;
        relative_velocity_at(k, u);
        const Components<Lanes>& w = softness_[k];
        const Components<Lanes> eps{proximal_ * w.n, proximal_ * w.t, proximal_ * w.r};
        cone_[k].linearise(u, eps, impedance_[k]);
        Components<Lanes> dp;  // the predictor's, which nearly always comes first
        cone_[k].set_targets(0, 0, dp);
        matrix_.rows()[k].momenta(dp, matrix_.momenta(k));
        cone_[k].visit_pairs([&](const Lanes& here, const Lanes& x, const Lanes&, const Lanes& y,
                                 const Lanes&) __attribute__((always_inline)) {
          part.by_power[0] += here * (x * y);
          part.pairs += here;
        });
      });
  products_[0] = sum(found.by_power[0]);
  pairs_ = sum(found.pairs);
  matrix_.factorise(impedance_);
}

double InteriorPoint::find_direction(const ContactProblem& problem, double tau, bool correct) {
  const double weight = correct ? 1 : 0;
  for_lane_blocks(problem.contacts.size(), [&](std::size_t k) __attribute__((always_inline)) {
    Components<Lanes> dp;
    cone_[k].set_targets(tau, weight, dp);
    matrix_.rows()[k].momenta(dp, matrix_.momenta(k));
  });
  return follow(problem);
}

double InteriorPoint::centre_direction(const ContactProblem& problem, double tau, double alpha) {
  const double foreseen = std::min(1.0, alpha + T::kFurther);
  const auto further = [&](const Lanes& x, const Lanes& dx, const Lanes& y, const Lanes& dy,
                           Lanes& more) __attribute__((always_inline)) {
    const Lanes product = (x + foreseen * dx) * (y + foreseen * dy), none{};
    const Lanes least = none + T::kLeastOfAim * tau, most = none + T::kMostOfAim * tau;
    more = larger<Lanes>(smaller(larger(product, least), most) - product, -most);
  };
  for_lane_blocks(problem.contacts.size(), [&](std::size_t k) __attribute__((always_inline)) {
    Components<Lanes> dp;
    cone_[k].adjust_targets(further, dp);
    matrix_.rows()[k].momenta(dp, matrix_.momenta(k));
  });
  return follow(problem);
}

double InteriorPoint::follow(const ContactProblem& problem) {
  matrix_.velocity_change(change_);
  const Products found = gather_lane_blocks<Products>(
      problem.contacts.size(), [&](std::size_t k, Products& part) __attribute__((always_inline)) {
        Components<Lanes> du;
        matrix_.rows()[k].relative_velocity(change_, du);
        cone_[k].find_direction(du);
        cone_[k].visit_pairs([&](const Lanes&, const Lanes& x, const Lanes& dx, const Lanes& y,
                                 const Lanes& dy) __attribute__((always_inline)) {
          // The faster of -dx/x and -dy/y, by one division.
          const Lanes ax = -dx * y, ay = -dy * x, scale = x * y;
          part.fastest = larger<Lanes>(part.fastest, larger(ax, ay) / scale);
          part.by_power[1] += x * dy + y * dx;
          part.by_power[2] += dx * dy;
        });
      });
  products_[1] = sum(found.by_power[1]);
  products_[2] = sum(found.by_power[2]);
  double fastest = 0;
  for (std::size_t k = 0; k < kLanes; ++k) fastest = std::max(fastest, found.fastest[k]);
  return 1 / fastest;
}

double InteriorPoint::mean_product(double alpha) const {
  const std::array<double, 3>& p = products_;
  return pairs_ > 0 ? (p[0] + alpha * (p[1] + alpha * p[2])) / pairs_ : 0;
}

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
  for_lane_blocks(nc, [&](std::size_t k) __attribute__((always_inline)) {
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
  path.report.velocity_change = std::sqrt(fastest_change(nc)) / problem.velocity_scale;
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
  const WorkClock::Span span(clock_, Work::cones);
  Path path{.problem = problem, .settings = settings, .state = state, .clock = clock_};
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
