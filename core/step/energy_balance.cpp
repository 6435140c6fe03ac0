#include "core/step/energy_balance.h"

#include "core/bodies/sorted_cursor.h"

namespace quicksand {

namespace {

void add_disks(const World& world, const std::vector<Vec3>& velocity, double dt,
               EnergyBalance& energy) {
  const Disks& disks = world.disks;
  const Vec2 g = world.gravity.value_or(Vec2(0, 0));
  for (int i = 0; i < disks.size(); ++i) {
    if (disks.fixed(i)) continue;
    const Vec3 sum = velocity[i] + disks.velocity[i], gain = velocity[i] - disks.velocity[i];
    energy.change += disks.mass[i] * sum.head<2>().dot(gain.head<2>()) / 2 +
                     disks.inertia(i) * sum.z() * gain.z() / 2;
    energy.work +=
        dt * (disks.mass[i] * g.dot(velocity[i].head<2>()) + disks.applied[i].dot(velocity[i]));
  }
  for (const ShapedBody& shaped : world.shapes.bodies) {
    const int i = shaped.body;
    if (disks.fixed(i)) continue;
    const double after = velocity[i].z(), before = disks.velocity[i].z();
    energy.change += (shaped.inertia - disks.inertia(i)) * (after + before) * (after - before) / 2;
  }
}

void add_walls(const World& world, const std::vector<Vec3>& velocity, double dt,
               EnergyBalance& energy) {
  const Vec2 g = world.gravity.value_or(Vec2(0, 0));
  for (std::size_t k = 0; k < world.walls.size(); ++k) {
    const Wall& wall = world.walls[k];
    if (wall.mass == 0) continue;
    // It moves freely along its normal only; what it does along itself is prescribed.
    const double after = wall.normal.dot(velocity[world.disks.position.size() + k].head<2>());
    const double before = wall.normal.dot(wall.velocity);
    energy.change += wall.mass * (after + before) * (after - before) / 2;
    energy.work += dt * (wall.force + wall.mass * wall.normal.dot(g)) * after;
  }
}

void add_contacts(const World& world, const std::vector<Contact>& contacts,
                  const ContactProblem& problem, const std::vector<Vec3>& velocity, double dt,
                  EnergyBalance& energy) {
  SortedCursor<const Bond> bonds(world.bonds.list);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    const ContactRow& row = problem.contacts[c];
    const Vec3 impulse = contact.impulse - Vec3(dt * contact.cohesion, 0, 0);
    // What does not respond to forces passes the work of the contact on; a wall with mass does along itself.
    if (world.disks.fixed(row.a)) energy.work -= momentum_of_a(row, impulse).dot(velocity[row.a]);
    if (is_wall(contact.pair.b) || world.disks.fixed(row.b)) {
      const Vec3& im = problem.inverse_mass[row.b];
      energy.work -= momentum_of_b(row, impulse)
                         .dot((im.array() == 0).select(velocity[row.b].array(), 0.0).matrix());
    }
    const Bond* bond = bonds.at(contact.pair);
    const bool lasts = bond && bond->state == BondState::active;
    // The gap that a bond leaves behind where it breaks is lost. That of one that lasts is where the next step finds it,
    // also where the bond has formed in this step, by a pair that passes and so leaves a gap.
    double stored = -contact.cohesion * contact.gap;
    if (lasts)
      stored += world.law(contact.pair).cohesion_force.value_or(0) *
                world.gap_after(contact.pair, velocity, dt);
    energy.change += stored;
  }
}

}  // namespace

EnergyBalance energy_balance(const World& world, const std::vector<Contact>& contacts,
                             const ContactProblem& problem, const std::vector<Vec3>& velocity,
                             double dt) {
  EnergyBalance energy;
  add_disks(world, velocity, dt, energy);
  add_walls(world, velocity, dt, energy);
  add_contacts(world, contacts, problem, velocity, dt, energy);
  return energy;
}

}  // namespace quicksand
