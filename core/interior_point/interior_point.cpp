#include "core/interior_point/interior_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/problem/delassus.h"
#include "core/problem/residual.h"
#include "core/sweeps/relaxation.h"

namespace quicksand {

namespace {

// Iterations after acceptance in which velocities may settle.
constexpr int kSettling = 3;
// Iterations of Newton's method on the modes that end a solution: with the right modes one makes it exact,
// more may find them where velocities have not settled.
constexpr int kFinishing = 1, kSearching = 3;
// Share of the way to the boundary that a step may go.
constexpr double kBoundaryShare = 0.995;
// Proximal term over the contact's Delassus diagonal. Over a whole ploughing run, 1e-9 left one step
// in six unconverged for lack of digits, 1e-8 to 1e-6 one in a thousand.
constexpr double kProximal = 1e-7;
// Where the path folds the term is raised to this, and beyond halved in each iteration: it slows the end
// of the path. Of 65 solutions of a collapse of 4800 grains, five failed with at most 1e-4.
constexpr double kProximalAtFolds = 1e-3;
constexpr double kProximalDecay = 0.5;
// Products below this share of what the tolerances ask for are rounding, and are not aimed at.
constexpr double kLeastProduct = 0.05;
// A step shorter than this is not taken; the products are aligned instead, at this share of their mean.
constexpr double kShortStep = 0.3;
constexpr double kAlignedShare = 0.5;
// A step that would be shorter than this is looked for once more, with the products kept within these shares
// of what is aimed at where a step longer by so much would bring them. Repeating it gains little.
constexpr double kLongStep = 0.95;
constexpr double kFurther = 0.3;
constexpr double kLeastOfAim = 0.1, kMostOfAim = 10;
// Beyond a fold of the path, products aim at this many times their mean.
constexpr double kGrowth = 20;
// Where within this distance so many factorisations gain less than this factor the path has jammed, and so many
// sweeps of relaxation, which cost less, are tried from the best state. 62 solutions under a piston are as much
// work where that begins within 300, after 5 factorisations. A path whose velocities have not settled has hardly begun:
// in debris that comes to rest the first eight steps are short, and what relaxation ends there is in free fall.
constexpr double kNear = 30, kGain = 0.8;
constexpr int kPatience = 8, kTrySweeps = 100;
// A path that is this long and comes within kNear goes on for the sake of some contacts that are still undecided,
// as far as velocities have settled to this share of their tolerance: so few sweeps are tried from there, and again
// whenever the distance has fallen by this factor. 51 solutions of a collapse of 4900 grains take 11.7 factorisations
// for 21.6; errors of their velocities are 0.4 % of the mean velocity for 0.15 %.
constexpr int kLongPath = 8, kFewSweeps = 8;
constexpr double kSettledShare = 0.1, kNearer = 0.7;
// No product may fall below this share of the mean: one pair at the boundary would block all others.
constexpr double kLeastShare = 1e-4;

// Whether velocities have settled so far that relaxation, which leaves long waves, may end a solution.
bool have_settled(const SolveReport& report, const SolverSettings& settings) {
  return report.velocity_change <= kSettledShare * settings.velocity_tolerance;
}

// Whether the path has jammed.
class Jam {
 public:
  // Told after each iteration, with the least distance before it. Says so once for each gain of the best.
  bool met(double distance, double best, std::int64_t factorisations) {
    if (distance < kGain * gained_) {
      gained_ = distance;
      gained_at_ = factorisations;
      return false;
    }
    if (best >= kNear || best >= kGain * met_at_ || factorisations - gained_at_ < kPatience)
      return false;
    met_at_ = best;
    return true;
  }

 private:
  double gained_ = std::numeric_limits<double>::infinity(), met_at_ = gained_;
  std::int64_t gained_at_ = 0;
};

// H velocity at a contact.
Vec3 contact_velocity(const ContactRow& row, const std::vector<Vec3>& velocity) {
  return relative_velocity(row, velocity[row.a], velocity[row.b]);
}

// Speed by which impulse p at relative velocity u is away from the laws.
double violation(const ContactRow& row, const Vec3& delassus, int components, const Vec3& p,
                 const Vec3& u) {
  const auto off = [](double x, double speed, double w, double low, double high) {
    return w > 0 ? std::abs(x - std::clamp(x - speed / w, low, high)) * w : 0;
  };
  const double n = std::max(0.0, p.x());
  double worst = off(p.x(), u.x(), delassus.x(), 0, std::numeric_limits<double>::infinity());
  if (components >= 2)
    worst = std::max(worst, off(p.y(), u.y(), delassus.y(), -row.friction * n, row.friction * n));
  if (components >= 3)
    worst = std::max(worst,
                     off(p.z(), u.z(), delassus.z(), -row.rolling * n, row.rolling * n) * row.arm);
  return worst;
}

}  // namespace

// The smallest product of an admissible error of an impulse and one of a speed.
double InteriorPoint::admissible_product(const ContactProblem& problem, double admissible) const {
  double least = std::numeric_limits<double>::infinity();
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
  proximal_ = kProximal;
  delassus_.resize(nc);
  cone_.assign(nc, {});
  stiffness_.resize(nc);
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
          stiffness_[c] = cone_[c].linearise(u, proximal_ * delassus_[c]);
          cone_[c].visit_pairs([&](double x, double, double y, double) {
            part.by_power[0] += x * y;
            ++part.pairs;
          });
        }
      });
  matrix_.factorise(stiffness_);
}

double InteriorPoint::find_direction(const ContactProblem& problem, double tau, bool correct) {
  share_range(cone_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) impulse_[c] = cone_[c].head_for(tau, correct);
  });
  return follow(problem);
}

double InteriorPoint::centre_direction(const ContactProblem& problem, double tau, double alpha) {
  const double foreseen = std::min(1.0, alpha + kFurther);
  const auto further = [&](double x, double dx, double y, double dy) {
    const double product = (x + foreseen * dx) * (y + foreseen * dy);
    const double wanted = std::clamp(product, kLeastOfAim * tau, kMostOfAim * tau);
    return std::max(wanted - product, -kMostOfAim * tau);
  };
  share_range(cone_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) impulse_[c] = cone_[c].head_further(further);
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
  const auto length = [](double longest) { return std::min(1.0, kBoundaryShare * longest); };
  if (matrix_.negative()) return length(find_direction(problem, kGrowth * product, false));
  const double affine = mean_product(std::min(1.0, find_direction(problem, 0, false)));
  const double centring = std::pow(std::max(0.0, affine / product), 3);
  const double aim = std::max(centring * product, least_product);
  double alpha = length(find_direction(problem, aim, true));
  if (alpha < kLongStep) alpha = length(centre_direction(problem, aim, alpha));
  if (alpha >= kShortStep) return alpha;
  return length(find_direction(problem, std::max(kAlignedShare * product, least_product), false));
}

bool InteriorPoint::finish(const ContactProblem& problem, const SolverSettings& settings,
                           ContactState& state, SolveReport& report) {
  const bool settled = report.velocity_change <= settings.velocity_tolerance;
  const SolveReport end =
      newton_.solve(problem, settings, settled ? kFinishing : kSearching, matrix_, state);
  report.residual = end.residual;
  report.velocity_change = std::min(report.velocity_change, end.velocity_change);
  report.factorisations += end.factorisations;
  return report.velocity_change <= settings.velocity_tolerance;
}

SolveReport InteriorPoint::relax(const ContactProblem& problem, const SolverSettings& settings,
                                 ContactState& state) {
  SolveReport report = solve_relaxation(problem, settings, state);
  if (!report.converged) return report;
  report.velocity_change = std::numeric_limits<double>::infinity();
  matrix_.attach(problem);
  finish(problem, settings, state, report);
  return report;
}

bool InteriorPoint::try_relaxation(const ContactProblem& problem, const SolverSettings& settings,
                                   int sweeps, ContactState& state, SolveReport& report) {
  SolverSettings few = settings;
  few.max_iterations =
      static_cast<int>(std::min<std::int64_t>(sweeps, settings.max_iterations - report.iterations));
  // Newton's method on modes that relaxation has decided gains nothing where velocities have settled.
  const bool settled = have_settled(report, settings);
  SolveReport relaxed =
      settled ? solve_relaxation(problem, few, relaxed_) : relax(problem, few, relaxed_);
  if (settled) relaxed.velocity_change = report.velocity_change;
  report.iterations += relaxed.iterations;
  report.factorisations += relaxed.factorisations;
  if (!relaxed.converged) return false;
  state = relaxed_;
  report.converged = true;
  report.residual = relaxed.residual;
  report.velocity_change = relaxed.velocity_change;
  return true;
}

SolveReport InteriorPoint::solve(const ContactProblem& problem, const SolverSettings& settings,
                                 double shift, ContactState& state) {
  SolveReport report;
  const double admissible = settings.tolerance * problem.force_scale * problem.dt;
  // The start counts: what is handed on is never worse than what came in.
  report.residual = residual(problem, state);
  report.converged = settings.accepts(report.residual);
  if (settings.distance(report.residual) <= SolverSettings::kAsItIs) return report;
  matrix_.attach(problem);
  report.velocity_change = std::numeric_limits<double>::infinity();
  if (report.converged && finish(problem, settings, state, report)) return report;
  start(problem, shift, state);
  const double least_product = kLeastProduct * admissible_product(problem, admissible);
  double best = settings.distance(report.residual);
  best_ = state.impulse;
  report.rung = shift > 1 ? Rung::far_start : Rung::interior_point;
  const double most_proximal = shift > 1 ? kProximal : kProximalAtFolds;
  Jam jam;
  double tried = std::numeric_limits<double>::infinity();  // where relaxation was last tried
  int settling = 0;
  while (report.factorisations < settings.max_factorisations) {
    linearise(problem);
    ++report.factorisations;
    if (matrix_.negative() && proximal_ < most_proximal) {
      proximal_ = most_proximal;
      linearise(problem);
      ++report.factorisations;
    } else {
      proximal_ = std::max(kProximal, kProximalDecay * proximal_);
    }
    const double product = mean_product(0);
    const double alpha = find_step(problem, product, least_product);
    share_range(cone_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        cone_[c].move(alpha);
        cone_[c].lift(kLeastShare * product);
        impulse_[c] = cone_[c].impulse();
        state.impulse[c] = cone_[c].admissible_impulse(delassus_[c].x());
      }
    });
    // The velocity is taken from the impulses and not summed up, so that the two cannot part.
    velocity_from_impulses(problem, impulse_, velocity_);
    report.residual = residual(problem, state);
    report.converged = settings.accepts(report.residual);
    report.velocity_change = fastest_at_contacts(problem, change_) / problem.velocity_scale;
    if (report.converged) {
      const bool settled = report.velocity_change <= settings.velocity_tolerance;
      const bool last = settled || ++settling > kSettling;
      const bool finishes = (last || settling == 1) && finish(problem, settings, state, report);
      if (last || finishes) return report;
    }
    if (!std::isfinite(product)) break;
    const double distance = settings.distance(report.residual);
    if (have_settled(report, settings) && report.factorisations >= kLongPath &&
        distance < std::min(kNear, kNearer * tried)) {
      tried = distance;
      relaxed_.impulse = state.impulse;
      if (try_relaxation(problem, settings, kFewSweeps, state, report)) return report;
    }
    if (report.velocity_change <= settings.velocity_tolerance &&
        jam.met(distance, best, report.factorisations)) {
      relaxed_.impulse = best_;
      if (try_relaxation(problem, settings, kTrySweeps, state, report)) return report;
    }
    if (distance < best) {
      best = distance;
      best_ = state.impulse;
    }
  }
  state.impulse = best_;
  report.residual = residual(problem, state);
  report.converged = settings.accepts(report.residual);
  return report;
}

}  // namespace quicksand
