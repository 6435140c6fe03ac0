#include "tests/support/core/simulation.h"

#include <cmath>

#include "core/measures/measures.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"

namespace quicksand {

Simulation::Simulation(const Scenario& scenario)
    : world(make_world(scenario)), step(scenario.step), solver(scenario.solver) {}

void Simulation::advance(int steps) {
  for (int k = 0; k < steps; ++k) {
    last = stepper_->advance(world, step, solver);
    bonds_broken += last.bonds_broken;
    bonds_formed += last.bonds_formed;
    breaks_withheld += last.breaks_withheld;
    unconverged += last.converged ? 0 : 1;
  }
}

void Simulation::run_for(double time) { advance(static_cast<int>(std::lround(time / step.dt))); }

Vec2 contact_force(const World& world, Pair pair) {
  for (const Contact& contact : world.contacts)
    if (contact.pair == pair) return contact.force(world.impulse_dt);
  return {0, 0};
}

Progress finish_phase(Protocol& protocol) {
  for (;;) {
    const Progress progress = protocol.advance();
    if (progress != Progress::running) return progress;
  }
}

Vec2 contact_force_on(const World& world, int body) {
  Vec2 sum(0, 0);
  for (const Contact& contact : world.contacts) {
    if (contact.pair.b == body) sum += contact.force(world.impulse_dt);
    if (contact.pair.a == body) sum -= contact.force(world.impulse_dt);
  }
  return sum;
}

Vec2 momentum(const World& world) {
  Vec2 sum(0, 0);
  for (int i = 0; i < world.disks.size(); ++i)
    if (!world.disks.fixed(i)) sum += world.disks.mass[i] * world.disks.velocity[i].head<2>();
  return sum;
}

double mechanical_energy(const World& world) {
  const Energies e = energies(world);
  double stretched = 0;
  for (const Bond& bond : world.bonds.list) {
    if (bond.state != BondState::active) continue;
    const double force = world.law(bond.pair).cohesion_force.value_or(0);
    stretched += force * std::max(0.0, world.gap(bond.pair));
  }
  return e.kinetic + e.rotational + e.potential + stretched;
}

void forget_forces(World& world) {
  world.contacts.clear();
  for (const Bond& bond : world.bonds.list)
    world.contacts.push_back(
        {.pair = bond.pair, .cohesion = world.law(bond.pair).cohesion_force.value_or(0)});
}

}  // namespace quicksand
