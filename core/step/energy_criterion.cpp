#include "core/step/energy_criterion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/memory.h"
#include "core/bodies/sorted_cursor.h"
#include "core/problem/delassus.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Impulses of the rough solution are off by at most this share of the least impact that can break a suspect.
constexpr double kRoughShare = 0.01;
// So many times as large may its openings be. In the paper's box under a push some are too small by more than a tenth in
// 20 of 278 steps in which any bond opens, by half in none. (With a share of 0.3, by half in 55 of 288.)
constexpr double kDoubt = 2;
// A bond that bears nearly F_c has hardly any energy left: its least impact, over that of an unloaded bond, is
// sqrt(1 - F_s/F_c). Below this share, from F_s = 0.99 F_c on, a solution that clears it would have to be exact for all.
constexpr double kSpent = 0.1;

// Impulse by which the turning of a pair loads its bond in a step, over dt: at its start the line of centres has turned
// away from the velocity, at its end the gap must not have opened.
double turning_load(const World& world, const Contact& contact, double delassus) {
  return (turning_rate(world, contact, world.disks.velocity) + contact.turning / 2) / delassus;
}

double normal_delassus(const World& world, const Contact& contact) {
  const auto [a, b] = world.rows(contact.pair);
  const Vec3 imb = is_wall(b) ? world.wall(b).inverse_mass() : world.disks.inverse_mass[b];
  ContactRow row{.normal = contact.normal};
  if (is_shaped(contact.pair)) {
    const double spin = contact.normal.dot(perpendicular(shaped_contact(world, contact.pair).arm));
    (is_wall(b) ? row.spin_a : row.spin_b).x() = spin;
  }
  return delassus_diagonal(row, world.disks.inverse_mass[a], imb).x();
}

// Where a solution without external forces is looked for: nothing but the cohesion, and friction that
// acts to its limit as in the step's solution p.
Vec3 without_load(const ContactRow& row, double cohesion, const Vec3& p, double dt) {
  constexpr double kAtLimit = 0.999;
  const double n = dt * cohesion;
  const auto at_limit = [&](double x, double coefficient) {
    return std::abs(x) < kAtLimit * coefficient * p.x() ? 0 : std::copysign(coefficient * n, x);
  };
  return {n, at_limit(p.y(), row.friction), at_limit(p.z(), row.rolling)};
}

}  // namespace

void EnergyCriterion::find_suspects(const Case& solved) {
  const auto& [world, contacts, step, settings, solver, cost] = solved;
  const double dt = step.dt;
  suspects_.clear();
  SortedCursor<const Contact> contacts_before(world.contacts);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    if (contact.cohesion == 0) continue;
    const Contact* before = contacts_before.at(contact.pair);
    // A bond under pressure has all of its energy left.
    const double tension = before ? -before->normal_force(world.impulse_dt) : 0;
    const double tension_before = std::clamp(tension, 0.0, contact.cohesion);
    const double energy_left =
        (contact.cohesion - tension_before) * world.law(contact.pair).cohesion_range;
    const double w = normal_delassus(world, contact);
    const double least_impact = std::sqrt(2 * energy_left / w);
    // What the step adds to the tension, or takes off the pressure; the turning of the pair is no part of it.
    const double added = dt * contact.cohesion - contact.impulse.x() - dt * tension;
    if (added <= least_impact) continue;
    const double impact =
        step.curvature_term ? added - dt * turning_load(world, contact, w) : added;
    if (impact <= least_impact) continue;
    suspects_.push_back(
        {.contact = c,
         .tension_before = tension_before,
         .impact = impact,
         .energy_left = energy_left,
         .least_impact = least_impact,
         .spent = contact.cohesion - tension_before < kSpent * kSpent * contact.cohesion});
  }
}

bool EnergyCriterion::solve_unloaded(const Case& solved, double admissible) {
  const auto& [world, contacts, step, settings, solver, cost] = solved;
  start_velocities(world, velocity_);
  build_problem(world, unloaded_, velocity_, step, problem_);
  for (ContactRow& row : problem_.contacts) row.gap_tolerance = kInfinity;
  set_size(state_.impulse, unloaded_.size());
  for (std::size_t c = 0; c < unloaded_.size(); ++c)
    state_.impulse[c] =
        without_load(problem_.contacts[c], unloaded_[c].cohesion, unloaded_[c].impulse, step.dt);
  SolverSettings own = settings;
  own.tolerance = std::max(settings.tolerance, admissible / (problem_.force_scale * step.dt));
  if (admissible > 0) own.velocity_tolerance = kInfinity;
  const SolverStage from = cost.stage;
  cost.add(solver.solve(problem_, own, state_, from));
  cost.stage = std::max(cost.stage, from);
  return cost.converged;
}

bool EnergyCriterion::find_impacts(const Case& solved) {
  const auto& [world, contacts, step, settings, solver, cost] = solved;
  unloaded_ = contacts;
  if (!solve_unloaded(solved, 0)) return false;
  for (Suspect& s : suspects_) {
    const Contact& bond = unloaded_[s.contact];
    double alone = step.dt * bond.cohesion - state_.impulse[s.contact].x();
    if (step.curvature_term)
      alone -= step.dt * turning_load(world, bond, normal_delassus(world, bond));
    s.own_impact = std::min(s.impact, alone);
  }
  return true;
}

bool EnergyCriterion::find_openings(const Case& solved, double admissible) {
  unloaded_ = solved.contacts;
  for (const Suspect& s : suspects_) unloaded_[s.contact].cohesion = 0;
  if (!solve_unloaded(solved, admissible)) return false;
  for (Suspect& s : suspects_) {
    const ContactRow& row = problem_.contacts[s.contact];
    s.opening = relative_velocity(row, state_.velocity[row.a], state_.velocity[row.b]).x();
  }
  return true;
}

const std::vector<BondBreak>& EnergyCriterion::failures(const World& world,
                                                        const std::vector<Contact>& contacts,
                                                        const StepSettings& step,
                                                        const SolverSettings& settings,
                                                        ContactSolver& solver, SolveReport& cost) {
  const Case solved{world, contacts, step, settings, solver, cost};
  const auto opens = [](const Suspect& s, double impact) {
    return impact * s.opening / 2 > s.energy_left;
  };
  breaks_.clear();
  find_suspects(solved);
  double rough = kInfinity;
  for (const Suspect& s : suspects_)
    if (!s.spent) rough = std::min(rough, kRoughShare * s.least_impact);
  // A rough solution that does not converge clears nothing, and leaves the decision to the exact ones.
  if (rough < kInfinity && find_openings(solved, rough))
    std::erase_if(suspects_,
                  [&](const Suspect& s) { return !s.spent && !opens(s, kDoubt * s.impact); });
  if (suspects_.empty() || !find_impacts(solved)) return breaks_;
  std::erase_if(suspects_, [](const Suspect& s) { return s.own_impact <= s.least_impact; });
  if (suspects_.empty() || !find_openings(solved, 0)) return breaks_;
  for (const Suspect& s : suspects_) {
    if (!opens(s, s.own_impact)) continue;
    const Contact& contact = contacts[s.contact];
    const double last_impulse =
        s.own_impact * (1 - std::sqrt(1 - 2 * s.energy_left / (s.own_impact * s.opening)));
    const double last_force = s.tension_before + last_impulse / step.dt;
    breaks_.push_back({contact.pair, std::min(last_force, contact.cohesion)});
  }
  return breaks_;
}

}  // namespace quicksand
