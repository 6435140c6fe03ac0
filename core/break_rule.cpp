#include "core/break_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/delassus.h"

namespace quicksand {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Impulses of the rough solution are off by at most this share of what puts the opening energy of a suspect off
// by its own, E, and it clears suspects whose opening takes less than the other share of E. Of 516 cleared
// judgements of a deposition, a push at dt = 1e-3 and a collapse the exact solution found 0.59 E at most.
constexpr double kRoughShare = 0.3;
constexpr double kClear = 0.5;

// Impulse by which the turning of a pair loads its bond in a step, over dt.
double turning_load(const World& world, const Contact& contact, double delassus) {
  return 1.5 * turning_rate(world, contact) / delassus;
}

double normal_delassus(const World& world, const Contact& contact) {
  const Vec3 imb = is_wall(contact.pair.b) ? world.wall(contact.pair.b).inverse_mass()
                                           : world.disks.inverse_mass[contact.pair.b];
  return delassus_diagonal({.normal = contact.normal}, world.disks.inverse_mass[contact.pair.a],
                           imb)
      .x();
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

void EnergyRule::find_suspects(const World& world, const std::vector<Contact>& contacts,
                               const StepSettings& step) {
  const double dt = step.dt;
  suspects_.clear();
  auto before = world.contacts.begin();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    if (contact.cohesion == 0) continue;
    while (before != world.contacts.end() && before->pair < contact.pair) ++before;
    const bool known = before != world.contacts.end() && before->pair == contact.pair;
    // A bond under pressure has all of its energy left.
    const double tension = known ? before->cohesion - before->impulse.x() / world.impulse_dt : 0;
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
    suspects_.push_back({.contact = c,
                         .tension_before = tension_before,
                         .impact = impact,
                         .energy_left = energy_left,
                         .telling_impulse = 2 * energy_left / (w * impact)});
  }
}

SolverSettings EnergyRule::rough_settings(const SolverSettings& settings) const {
  double telling_impulse = kInfinity;
  for (const Suspect& s : suspects_) telling_impulse = std::min(telling_impulse, s.telling_impulse);
  SolverSettings rough = settings;
  rough.tolerance = kRoughShare * telling_impulse / (problem_.force_scale * problem_.dt);
  rough.velocity_tolerance = kInfinity;
  return rough;
}

double EnergyRule::opening_energy(const Suspect& suspect) const {
  const ContactRow& row = problem_.contacts[suspect.contact];
  return suspect.impact / 2 *
         relative_velocity(row, state_.velocity[row.a], state_.velocity[row.b]).x();
}

const std::vector<BondBreak>& EnergyRule::judge(const World& world,
                                                const std::vector<Contact>& contacts,
                                                const StepSettings& step,
                                                const SolverSettings& settings,
                                                ContactSolver& solver, SolveReport& cost) {
  breaks_.clear();
  find_suspects(world, contacts, step);
  if (suspects_.empty()) return breaks_;

  // The step without external forces and without the suspected bonds. Nothing moves by it: gaps do not count.
  without_ = contacts;
  for (const Suspect& s : suspects_) without_[s.contact].cohesion = 0;
  start_velocities(world, velocity_);
  build_problem(world, without_, velocity_, step, problem_);
  for (ContactRow& row : problem_.contacts) row.gap_tolerance = kInfinity;
  state_.impulse.resize(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c)
    state_.impulse[c] =
        without_load(problem_.contacts[c], without_[c].cohesion, contacts[c].impulse, step.dt);

  const SolverSettings rough = rough_settings(settings);
  const Rung of_step = cost.rung;
  if (rough.tolerance > settings.tolerance) {
    cost.add(solver.solve(problem_, rough, state_, of_step));
    const auto clear = [&](const Suspect& s) { return opening_energy(s) < kClear * s.energy_left; };
    if (cost.converged && std::ranges::all_of(suspects_, clear)) return breaks_;
  }
  cost.add(solver.solve(problem_, settings, state_, std::max(of_step, cost.rung)));
  if (!cost.converged) return breaks_;
  for (const Suspect& s : suspects_) {
    const double energy = opening_energy(s);
    if (energy <= s.energy_left) continue;
    const Contact& contact = contacts[s.contact];
    const double last_impulse = s.impact * (1 - std::sqrt(1 - s.energy_left / energy));
    const double last_force = s.tension_before + last_impulse / step.dt;
    breaks_.push_back({contact.pair, std::min(last_force, contact.cohesion)});
  }
  return breaks_;
}

}  // namespace quicksand
