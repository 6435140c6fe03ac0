#include "core/step/assemble.h"

#include <algorithm>
#include <cmath>

#include "core/base/memory.h"
#include "core/bodies/sorted_cursor.h"
#include "core/step/lengths.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

// Pairs beyond kAlwaysWithin may become faster by what happens in the step: so many times their free velocity. A
// contact that stays open costs far less than to solve again with one that was missed: in a collapse, 2 % more
// contacts save two thirds of the repeats.
constexpr double kForesight = 2;

}  // namespace

void start_velocities(const World& world, std::vector<Vec3>& velocity) {
  velocity.reserve(world.disks.velocity.size() + world.walls.size());
  velocity.assign(world.disks.velocity.begin(), world.disks.velocity.end());
  for (const Wall& wall : world.walls)
    velocity.emplace_back(wall.velocity.x(), wall.velocity.y(), 0);
}

double turning_rate(const World& world, const Contact& contact, const std::vector<Vec3>& velocity) {
  const auto [a, b] = contact.pair;
  if (!is_disk(b)) {
    return is_shaped(contact.pair) ? shaped_turning_rate(world, contact.pair, velocity) : 0;
  }
  const Vec3 u = velocity[b] - velocity[a];
  const double u_ct = perpendicular(contact.normal).dot(u.head<2>());
  return u_ct * u_ct / (world.disks.radius[a] + world.disks.radius[b] + contact.gap);
}

namespace {

// The fastest of all bonded pairs, |u_ct|/D [rad sqrt(g/d)].
double fastest_turning(const World& world) {
  double fastest = 0;
  for (const Bond& bond : world.bonds.list) {
    const auto [a, b] = bond.pair;
    if (bond.state == BondState::broken) continue;
    if (!is_disk(b)) {
      if (is_shaped(bond.pair))
        fastest =
            std::max(fastest, std::abs(world.disks.velocity[world.row(is_wall(b) ? a : b)].z()));
      continue;
    }
    const Vec2 u = (world.disks.velocity[b] - world.disks.velocity[a]).head<2>();
    if (u.isZero(0)) continue;
    const Vec2 apart = world.separation(a, b);
    fastest = std::max(fastest, std::abs(perpendicular(apart).dot(u)) / apart.squaredNorm());
  }
  return fastest;
}

}  // namespace

int halvings_by_turning(const World& world, const StepSettings& step) {
  if (!step.max_turn) return 0;
  const double turn = step.dt * fastest_turning(world);
  int halvings = 0;
  while (halvings < step.max_halvings && std::ldexp(turn, -halvings) > *step.max_turn) ++halvings;
  return halvings;
}

double fastest(const World& world, const std::vector<Vec3>& velocity) {
  double squared = 0;
  for (const Vec3& v : velocity) squared = std::max(squared, v.head<2>().squaredNorm());
  double fastest = std::sqrt(squared);
  for (const ShapedBody& shaped : world.shapes.bodies) {
    const Vec3& v = velocity[shaped.body];
    fastest = std::max(fastest, v.head<2>().norm() + shaped.arm * std::abs(v.z()));
  }
  return fastest;
}

void free_velocities(const World& world, double dt, std::vector<Vec3>& velocity) {
  const Disks& disks = world.disks;
  start_velocities(world, velocity);
  const Vec2 g = world.gravity.value_or(Vec2(0, 0));
  for (int i = 0; i < disks.size(); ++i) {
    if (disks.fixed(i)) continue;
    velocity[i] +=
        dt * (Vec3(g.x(), g.y(), 0) + disks.inverse_mass[i].cwiseProduct(disks.applied[i]));
  }
  for (std::size_t k = 0; k < world.walls.size(); ++k) {
    const Wall& wall = world.walls[k];
    if (wall.mass == 0) continue;
    Vec3& v = velocity[disks.position.size() + k];
    const Vec2 push = wall.force * wall.normal + wall.mass * g;
    v += dt * wall.inverse_mass().cwiseProduct(Vec3(push.x(), push.y(), 0));
  }
  if (world.drag) apply_drag(*world.drag, world.disks, dt, velocity);
}

const std::vector<Vec3>& by_loads(const World& world, std::vector<Vec3>& free_velocity) {
  const std::size_t nd = world.disks.position.size();
  for (std::size_t i = 0; i < nd; ++i) free_velocity[i] -= world.disks.velocity[i];
  for (std::size_t k = 0; k < world.walls.size(); ++k)
    free_velocity[nd + k].head<2>() -= world.walls[k].velocity;
  return free_velocity;
}

namespace {

double relative_speed(const World& world, const Pair& pair, const std::vector<Vec3>& velocity) {
  if (!is_disk(pair.b) && is_shaped(pair)) return closing_speed(world, pair, velocity);
  return (velocity[world.velocity_row(pair.b)] - velocity[pair.a]).head<2>().norm();
}

}  // namespace

double contact_reach(const World& world, const std::vector<Vec3>& free_velocity, double dt) {
  double reach = std::max(kAlwaysWithin, 2 * dt * fastest(world, free_velocity));
  for (const ContactLaw* law : {&world.grain_law, &world.wall_law, &world.intruder_law})
    if (law->cohesion_force) reach = std::max(reach, law->cohesion_range);
  return reach;
}

void find_contacts(const World& world, const std::vector<Pair>& candidates,
                   const std::vector<Vec3>& free_velocity, double dt,
                   std::vector<Contact>& contacts) {
  contacts.clear();
  const double reach = contact_reach(world, free_velocity, dt);
  const double scale = world.impulse_dt > 0 ? dt / world.impulse_dt : 0;
  SortedCursor<const Contact> old_contacts(world.contacts);
  SortedCursor<const Bond> bonds(world.bonds.list);
  for (const Pair& pair : candidates) {
    const Bond* bond = bonds.at(pair);
    const Contact* old = old_contacts.at(pair);
    const bool bonded = bond && bond->state == BondState::active;
    Vec2 normal;
    const double gap = world.gap(pair, &normal);
    if (gap > reach) continue;
    if (!bonded && gap > kAlwaysWithin) {
      // The normal turns while bodies pass each other, hence their whole relative speed.
      if (gap > kForesight * dt * relative_speed(world, pair, free_velocity)) continue;
    }
    if (!world.movable(pair)) continue;
    Contact& contact = append(contacts, Contact{.pair = pair});
    contact.normal = normal;
    contact.gap = gap;
    const ContactLaw& law = world.law(pair);
    if (bonded) contact.cohesion = law.cohesion_force.value_or(0);
    if (contact.cohesion > 0) contact.turning = turning_rate(world, contact, world.disks.velocity);
    if (!old) {
      contact.impulse.x() = dt * contact.cohesion;
      continue;
    }
    contact.impulse = scale * old->impulse;
    if (!law.friction) contact.impulse.y() = 0;
    if (!law.rolling_friction) contact.impulse.z() = 0;
    // N includes the cohesion: a bond that came or went since takes its part along.
    contact.impulse.x() += dt * (contact.cohesion - old->cohesion);
    contact.impulse.x() = std::max(0.0, contact.impulse.x());
  }
}

int add_missed_contacts(const World& world, const std::vector<Pair>& candidates,
                        const std::vector<Vec3>& velocity, double dt, double tolerance,
                        std::vector<Contact>& contacts) {
  std::vector<Contact> missed;
  SortedCursor<const Contact> known(contacts);
  for (const Pair& pair : candidates) {
    if (known.at(pair)) continue;
    if (!is_disk(pair.b) && is_shaped(pair)) {
      if (!world.movable(pair) || !meets_within(world, pair, velocity, dt, tolerance)) continue;
      Contact& contact = missed.emplace_back(Contact{.pair = pair});
      contact.gap = world.gap(pair, &contact.normal);
      continue;
    }
    const Vec3 u = velocity[world.velocity_row(pair.b)] - velocity[pair.a];
    const double path = dt * u.head<2>().norm();
    if (path < kAlwaysWithin) continue;  // what is nearer is a contact already
    Contact contact{.pair = pair};
    contact.gap = world.gap(pair, &contact.normal);
    if (contact.gap + tolerance > path) continue;
    if (world.gap_after(pair, velocity, dt) < -tolerance && world.movable(pair))
      missed.push_back(contact);
  }
  const auto first_missed = contacts.insert(contacts.end(), missed.begin(), missed.end());
  std::ranges::inplace_merge(contacts, first_missed, {}, &Contact::pair);
  return static_cast<int>(missed.size());
}

bool correct_turning(const World& world, const std::vector<Vec3>& velocity, double dt,
                     double tolerance, std::vector<Contact>& contacts) {
  const auto off = [&](const Contact& c) {
    const double rate = turning_rate(world, c, velocity);
    return c.cohesion > 0 && dt * dt / 2 * std::abs(rate - c.turning) > tolerance;
  };
  if (std::ranges::none_of(contacts, off)) return false;
  for (Contact& c : contacts)
    if (c.cohesion > 0) c.turning = turning_rate(world, c, velocity);
  return true;
}

namespace {

// Spins, arm and rolling length of disks and walls.
void shape_row(const World& world, Pair pair, double rolling, ContactRow& row) {
  const double radius = world.disks.radius[pair.a];
  row.spin_a.y() = row.arm = radius;
  if (is_wall(pair.b)) {
    row.rolling = rolling_length_on_wall(rolling, radius);
    return;
  }
  const double other = world.disks.radius[pair.b];
  row.spin_b.y() = -other;
  row.arm = (radius + other) / 2;
  row.rolling = rolling_length(rolling, radius, other);
}

// The same of a shaped body.
void shape_shaped_row(const World& world, Pair pair, double rolling, ContactRow& row) {
  const ShapedContact contact = shaped_contact(world, pair);
  const Vec2 turned = perpendicular(contact.arm);
  const Vec2 of_foot(row.normal.dot(turned), perpendicular(row.normal).dot(turned));
  if (is_wall(pair.b)) {
    row.spin_a = of_foot + Vec2(0, contact.radius);
    row.arm = contact.radius;
    row.rolling = rolling_length_on_wall(rolling, contact.radius);
    return;
  }
  const double radius = world.disks.radius[pair.a];
  row.spin_a.y() = radius;
  row.spin_b = of_foot - Vec2(0, contact.radius);
  row.arm = (radius + contact.radius) / 2;
  row.rolling = contact.flank ? rolling_length_on_flank(rolling, radius)
                              : rolling_length(rolling, radius, contact.radius);
}

ContactRow row_of(const World& world, const Contact& contact, const StepSettings& step) {
  const ContactLaw& law = world.law(contact.pair);
  ContactRow row{.a = world.velocity_row(contact.pair.a),
                 .b = world.velocity_row(contact.pair.b),
                 .normal = contact.normal};
  row.friction = law.friction.value_or(0);
  const double rolling = law.rolling_friction.value_or(0);
  if (!is_disk(contact.pair.b) && is_shaped(contact.pair))
    shape_shaped_row(world, contact.pair, rolling, row);
  else
    shape_row(world, contact.pair, rolling, row);
  row.gap_tolerance =
      contact.cohesion == 0 ? kPlainGapTolerance : kBondGapShare * law.cohesion_range;
  if (std::abs(contact.gap) > std::min(kLeastGap, kLeastGapShare * row.gap_tolerance))
    row.offset.x() = contact.gap / step.dt;
  row.cohesive = contact.cohesion > 0;
  if (row.cohesive && step.curvature_term) row.offset.x() += step.dt * contact.turning / 2;
  return row;
}

// Forces are measured relative to the strongest bond, or the mean force or momentum of a body.
void set_scales(const World& world, const std::vector<Vec3>& free_velocity, double strongest_bond,
                ContactProblem& problem) {
  const Disks& disks = world.disks;
  const double dt = problem.dt;
  double force = 0, mass = 0;
  int mobile = 0;
  const auto add = [&](double of_body, const Vec2& change, const Vec2& start) {
    ++mobile;
    mass += of_body;
    force += of_body * std::sqrt(std::max(change.squaredNorm(), start.squaredNorm())) / dt;
  };
  for (int i = 0; i < disks.size(); ++i)
    if (!disks.fixed(i))
      add(disks.mass[i], (free_velocity[i] - disks.velocity[i]).head<2>(),
          disks.velocity[i].head<2>());
  for (std::size_t k = 0; k < world.walls.size(); ++k)
    if (const Wall& wall = world.walls[k]; wall.mass != 0)
      add(wall.mass, free_velocity[disks.position.size() + k].head<2>() - wall.velocity,
          wall.velocity);
  problem.velocity_scale = force > 0 ? dt * force / mass : 1;
  if (mobile > 0) force /= mobile;
  problem.force_scale = std::max(strongest_bond, force);
  if (problem.force_scale == 0) problem.force_scale = 1;
}

}  // namespace

void build_problem(const World& world, const std::vector<Contact>& contacts,
                   const std::vector<Vec3>& free_velocity, const StepSettings& step,
                   ContactProblem& problem) {
  problem.dt = step.dt;
  problem.inverse_mass.reserve(free_velocity.size());
  problem.inverse_mass.assign(world.disks.inverse_mass.begin(), world.disks.inverse_mass.end());
  for (const Wall& wall : world.walls) problem.inverse_mass.push_back(wall.inverse_mass());
  if (world.drag) apply_drag(*world.drag, world.disks, step.dt, problem.inverse_mass);
  problem.free_velocity = free_velocity;

  const auto has = [&](auto term) {
    return world.grain_law.*term || world.wall_law.*term || world.intruder_law.*term;
  };
  problem.components = has(&ContactLaw::rolling_friction) ? 3 : has(&ContactLaw::friction) ? 2 : 1;
  // A normal force on a shaped body turns it, and a single component reads no spins.
  if (!world.shapes.empty()) problem.components = std::max(2, problem.components);

  double strongest_bond = 0;
  set_size(problem.contacts, contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Contact& contact = contacts[c];
    const ContactRow& row = problem.contacts[c] = row_of(world, contact, step);
    if (!row.cohesive) continue;
    strongest_bond = std::max(strongest_bond, contact.cohesion);
    const Vec3 attraction(step.dt * contact.cohesion, 0, 0);
    problem.free_velocity[row.a] -=
        problem.inverse_mass[row.a].cwiseProduct(momentum_of_a(row, attraction));
    problem.free_velocity[row.b] -=
        problem.inverse_mass[row.b].cwiseProduct(momentum_of_b(row, attraction));
  }
  set_scales(world, free_velocity, strongest_bond, problem);
}

}  // namespace quicksand
