#include "core/solvers/local.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/memory.h"
#include "core/problem/delassus.h"
#include "core/problem/projection.h"
#include "core/problem/residual.h"
#include "core/problem/rest.h"

namespace quicksand {

namespace {

constexpr int kMaxRounds = 12;
// A contact is frozen if its last impulse was inside its cone by this share and by so many times the
// admissible residual.
constexpr double kShareInside = 1e-3;
constexpr double kMarginInside = 10;
// Share of contacts that must be frozen or open for the local solver to be tried.
constexpr double kLeastQuiet = 0.8;
// Share of contacts that may be released or join in: where more do, the whole problem is solved sooner. (Of 61 solutions
// of an intruder that begins to plough, 51 ms for 58; none of a deposition releases as many.)
constexpr double kMostReleased = 0.09;
// Factorisations of the whole problem whose work the local solver may spend. Where nearly all moves, the rounds
// would cost several times the full solution, which takes 25 to 80.
constexpr double kWorth = 25;

bool whole(const Vec3& im) { return im.isZero(0) || (im.minCoeff() > 0 && im.x() == im.y()); }

bool inside_cone(const ContactRow& row, const Vec3& p, double margin) {
  const auto inside = [&](double x, double bound) {
    return std::abs(x) <= (1 - kShareInside) * bound - margin;
  };
  return p.x() > margin && inside(p.y(), row.friction * p.x()) &&
         inside(p.z(), row.rolling * p.x());
}

}  // namespace

bool LocalSolver::assign_roles(const ContactProblem& problem, double admissible,
                               ContactState& state) {
  set_size(role_, problem.contacts.size());
  for (std::size_t c = 0; c < role_.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    Vec3& p = state.impulse[c];
    p = project(row, p);
    role_[c] = Role::active;
    if (p.x() == 0) {
      const Vec3 u = relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
      if (row.offset.x() + u.x() > 0) role_[c] = Role::open;
    } else if (inside_cone(row, p, kMarginInside * admissible) &&
               whole(problem.inverse_mass[row.a]) && whole(problem.inverse_mass[row.b])) {
      role_[c] = Role::frozen;
    }
  }
  const auto active = std::ranges::count(role_, Role::active);
  return static_cast<double>(active) <= (1 - kLeastQuiet) * static_cast<double>(role_.size());
}

void LocalSolver::find_components(const ContactProblem& problem) {
  component_.resize(static_cast<std::size_t>(clusters_.size()));
  std::iota(component_.begin(), component_.end(), 0);
  const auto find = [&](int k) {
    while (component_[k] != k) k = component_[k] = component_[component_[k]];
    return k;
  };
  const auto mobile = [&](int k) { return !clusters_.inverse_mass(k).isZero(0); };
  by_component_.clear();
  for (std::size_t c = 0; c < role_.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    if (role_[c] == Role::open || clusters_.in_tree(c) || clusters_.inside(row)) continue;
    const int a = clusters_.cluster_of(row.a), b = clusters_.cluster_of(row.b);
    if (!mobile(a) && !mobile(b)) continue;
    by_component_.push_back(c);
    if (mobile(a) && mobile(b)) component_[std::max(find(a), find(b))] = std::min(find(a), find(b));
  }
  const auto component_of = [&](std::size_t c) {
    const ContactRow& row = problem.contacts[c];
    const int a = clusters_.cluster_of(row.a);
    return find(mobile(a) ? a : clusters_.cluster_of(row.b));
  };
  std::ranges::sort(by_component_, {},
                    [&](std::size_t c) { return std::pair(component_of(c), c); });
  component_start_.assign(1, 0);
  for (std::size_t k = 1; k <= by_component_.size(); ++k)
    if (k == by_component_.size() ||
        component_of(by_component_[k]) != component_of(by_component_[k - 1]))
      component_start_.push_back(k);
}

int LocalSolver::local_body(int cluster) {
  if (local_[cluster] < 0) {
    local_[cluster] = static_cast<int>(part_cluster_.size());
    part_cluster_.push_back(cluster);
    part_.inverse_mass.push_back(clusters_.inverse_mass(cluster));
    part_.free_velocity.push_back(clusters_.free_velocity(cluster));
  }
  return local_[cluster];
}

void LocalSolver::pose_component(const ContactProblem& problem, std::size_t first, std::size_t last,
                                 const std::vector<Vec3>& impulse) {
  part_.dt = problem.dt;
  part_.force_scale = problem.force_scale;
  part_.velocity_scale = problem.velocity_scale;
  part_.components = problem.components;
  part_.inverse_mass.clear();
  part_.free_velocity.clear();
  part_.contacts.clear();
  part_cluster_.clear();
  part_state_.impulse.clear();
  for (std::size_t k = first; k < last; ++k) {
    ContactRow row = clusters_.row_between(problem.contacts[by_component_[k]]);
    row.a = local_body(row.a);
    row.b = local_body(row.b);
    part_.contacts.push_back(row);
    part_state_.impulse.push_back(impulse[by_component_[k]]);
  }
}

bool LocalSolver::solve_components(const ContactProblem& problem, const SolverSettings& settings,
                                   std::vector<Vec3>& impulse, SolveReport& report) {
  cluster_velocity_.clear();
  velocity_change_ = 0;
  for (int k = 0; k < clusters_.size(); ++k)
    cluster_velocity_.push_back(clusters_.free_velocity(k));
  local_.assign(static_cast<std::size_t>(clusters_.size()), -1);
  for (std::size_t part = 0; part + 1 < component_start_.size(); ++part) {
    const std::size_t first = component_start_[part], last = component_start_[part + 1];
    pose_component(problem, first, last, impulse);
    const double size = static_cast<double>(last - first);
    SolverSettings affordable = settings;
    affordable.max_factorisations =
        std::min(settings.max_factorisations, static_cast<int>(std::ceil(budget_ / size)));
    const SolveReport solved = interior_point_.solve(part_, affordable, 1, part_state_);
    budget_ -= static_cast<double>(solved.factorisations) * size;
    report.add(solved);
    velocity_change_ = std::max(velocity_change_, solved.velocity_change.value_or(0));
    for (std::size_t k = first; k < last; ++k)
      impulse[by_component_[k]] = part_state_.impulse[k - first];
    for (std::size_t k = 0; k < part_cluster_.size(); ++k) {
      cluster_velocity_[part_cluster_[k]] = part_state_.velocity[k];
      local_[part_cluster_[k]] = -1;
    }
    if (!report.converged) return false;
  }
  return true;
}

// Contacts that are not active and yet violate the law become active. Returns how many, or -1 if some
// cannot.
int LocalSolver::activate_violated(const ContactProblem& problem, double admissible,
                                   ContactState& state) {
  violation_.assign(role_.size(), 0);
  worst_at_.assign(problem.inverse_mass.size(), 0);
  int activated = 0;
  for (std::size_t c = 0; c < role_.size(); ++c) {
    if (role_[c] == Role::active) continue;
    const ContactRow& row = problem.contacts[c];
    const Vec3 u =
        row.offset + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
    const double v =
        contact_residual(problem, row, inverse_delassus(problem, row), state.impulse[c], u);
    if (v <= admissible) continue;
    if (role_[c] == Role::open) {
      if (clusters_.inside(row)) return -1;
      role_[c] = Role::active;
      ++activated;
      continue;
    }
    if (!clusters_.in_tree(c)) return -1;
    // What the contact keeps, should the next tree leave it out.
    state.impulse[c] = project(row, state.impulse[c]);
    violation_[c] = v;
    worst_at_[row.a] = std::max(worst_at_[row.a], v);
    worst_at_[row.b] = std::max(worst_at_[row.b], v);
  }
  for (std::size_t c = 0; c < role_.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    if (violation_[c] == 0 || violation_[c] < worst_at_[row.a] || violation_[c] < worst_at_[row.b])
      continue;
    role_[c] = Role::active;
    ++activated;
  }
  return activated;
}

bool LocalSolver::solve_in_rounds(const ContactProblem& problem, const SolverSettings& settings,
                                  double admissible, ContactState& state, SolveReport& report) {
  const auto accepted = [&] {
    report.stage = SolverStage::local;
    report.velocity_change = velocity_change_;
    return report.measure(problem, settings, state);
  };
  budget_ = kWorth * static_cast<double>(role_.size());
  int released = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    set_size(frozen_, role_.size());
    std::ranges::transform(role_, frozen_.begin(), [](Role r) { return r == Role::frozen; });
    clusters_.join(problem, frozen_);
    clusters_.find_mass_properties(problem, state.impulse);
    find_components(problem);
    if (!solve_components(problem, settings, state.impulse, report)) break;
    clusters_.spread(cluster_velocity_, state.velocity);
    clusters_.recover(problem, state.velocity, state.impulse);
    // Where the network holds as a whole, its residual says so at once.
    if (by_component_.empty() && accepted()) return true;
    const int activated = activate_violated(problem, admissible, state);
    released += activated;
    if (activated <= 0 || released > kMostReleased * static_cast<double>(role_.size())) break;
  }
  // Components that converged do not make a solution: the residual of the whole problem decides.
  return accepted();
}

SolveReport LocalSolver::solve(const ContactProblem& problem, const SolverSettings& settings,
                               ContactState& state) {
  SolveReport report;
  report.residual = residual(problem, state, settings.residual_at(SolverSettings::kAsItIs));
  report.converged = taken_as_it_is(problem, settings, report.residual, state);
  if (report.converged) return report;
  const double admissible = settings.tolerance * problem.force_scale * problem.dt;
  start_impulse_ = state.impulse;
  // Without rolling friction no contact holds rigidly.
  if (problem.components == 3 && assign_roles(problem, admissible, state) &&
      solve_in_rounds(problem, settings, admissible, state, report))
    return report;
  state.impulse = start_impulse_;
  report.residual = residual(problem, state);
  report.converged = false;  // it was not taken as it is
  report.velocity_change.reset();
  return report;
}

}  // namespace quicksand
