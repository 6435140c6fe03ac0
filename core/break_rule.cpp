#include "core/break_rule.h"

#include <algorithm>
#include <cmath>

#include "core/delassus.h"

namespace quicksand {

namespace {

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

}  // namespace

void EnergyRule::find_suspects(const World& world, const std::vector<Contact>& contacts,
                               double dt) {
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
    const double w = normal_delassus(world, contact);
    const Suspect suspect{.contact = c,
                          .tension_before = tension_before,
                          .impact = dt * contact.cohesion - contact.impulse.x() -
                                    dt * tension_before - dt * turning_load(world, contact, w)};
    if (may_break(world, contact, suspect)) suspects_.push_back(suspect);
  }
}

bool EnergyRule::may_break(const World& world, const Contact& contact, const Suspect& suspect) {
  const double energy_left =
      (contact.cohesion - suspect.tension_before) * world.law(contact.pair).cohesion_range;
  const double j = suspect.impact;
  return j > 0 && j * j * normal_delassus(world, contact) / 2 > energy_left;
}

const std::vector<BondBreak>& EnergyRule::judge(const World& world,
                                                const std::vector<Contact>& contacts,
                                                const StepSettings& step,
                                                const SolverSettings& settings,
                                                ContactSolver& solver, SolveReport& cost) {
  breaks_.clear();
  find_suspects(world, contacts, step.dt);
  if (suspects_.empty()) return breaks_;

  start_velocities(world, velocity_);
  const auto solve_with = [&](const std::vector<Contact>& these) {
    build_problem(world, these, velocity_, step, problem_);
    state_.impulse.resize(these.size());
    for (std::size_t c = 0; c < these.size(); ++c) state_.impulse[c] = these[c].impulse;
    cost.add(solver.solve(problem_, settings, state_));
    return cost.converged;
  };
  // The impact's own impulse: the step without external forces.
  if (!solve_with(contacts)) return breaks_;
  for (Suspect& s : suspects_) {
    const Contact& contact = contacts[s.contact];
    s.impact = step.dt * contact.cohesion - state_.impulse[s.contact].x() -
               step.dt * turning_load(world, contact, normal_delassus(world, contact));
  }
  // Often the external forces alone had made the suspicion.
  if (std::ranges::none_of(
          suspects_, [&](const Suspect& s) { return may_break(world, contacts[s.contact], s); }))
    return breaks_;
  // The velocity of opening: the same without the suspected bonds.
  without_ = contacts;
  for (const Suspect& s : suspects_) {
    Contact& contact = without_[s.contact];
    contact.impulse.x() = std::max(0.0, contact.impulse.x() - step.dt * contact.cohesion);
    contact.cohesion = 0;
  }
  if (!solve_with(without_)) return breaks_;
  for (const Suspect& s : suspects_) {
    const ContactRow& row = problem_.contacts[s.contact];
    const double opening =
        relative_velocity(row, state_.velocity[row.a], state_.velocity[row.b]).x();
    const Contact& contact = contacts[s.contact];
    const double energy_left =
        (contact.cohesion - s.tension_before) * world.law(contact.pair).cohesion_range;
    const double spent = energy_left / (s.impact * opening / 2);
    if (opening <= 0 || s.impact <= 0 || spent >= 1) continue;
    const double last_impulse = s.impact * (1 - std::sqrt(1 - spent));
    const double last_force = s.tension_before + last_impulse / step.dt;
    breaks_.push_back({contact.pair, std::min(last_force, contact.cohesion)});
  }
  return breaks_;
}

}  // namespace quicksand
