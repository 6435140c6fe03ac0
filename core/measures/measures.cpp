#include "core/measures/measures.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>

#include "core/world/extent.h"
#include "core/world/neighbors.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

// Gap up to which two bodies count as touching, where no cohesion range says so. [d]
constexpr double kTouching = 5e-5;

double touching_gap(const ContactLaw& law) {
  return law.cohesion_force ? law.cohesion_range : kTouching;
}

// Area of the part of a disk below the height y above its centre.
double disk_area_below(double radius, double y) {
  const double h = std::clamp(y / radius, -1.0, 1.0);
  return radius * radius * (std::numbers::pi / 2 + std::asin(h) + h * std::sqrt(1 - h * h));
}

bool touches(const World& world, Pair pair, std::optional<double> gap) {
  return world.movable(pair) && world.gap(pair) <= gap.value_or(touching_gap(world.law(pair)));
}

}  // namespace

double widest_touching_gap(const World& world) {
  return std::max({touching_gap(world.grain_law), touching_gap(world.wall_law),
                   touching_gap(world.intruder_law)});
}

std::vector<Pair> touching_pairs(const World& world, std::optional<double> gap) {
  std::vector<Pair> pairs = pairs_within(world, gap.value_or(widest_touching_gap(world)));
  std::erase_if(pairs, [&](Pair pair) { return !touches(world, pair, gap); });
  return pairs;
}

Energies energies(const World& world) {
  Energies sum;
  const Disks& disks = world.disks;
  for (int i = 0; i < disks.size(); ++i) {
    if (disks.fixed(i)) continue;
    sum.kinetic += disks.mass[i] * disks.velocity[i].head<2>().squaredNorm() / 2;
    sum.rotational += disks.inertia(i) * disks.velocity[i].z() * disks.velocity[i].z() / 2;
    if (world.gravity) sum.potential -= disks.mass[i] * world.gravity->dot(disks.position[i]);
  }
  for (const ShapedBody& shaped : world.shapes.bodies) {
    const int i = shaped.body;
    if (disks.fixed(i)) continue;
    const double spin = disks.velocity[i].z();
    sum.rotational += (shaped.inertia - disks.inertia(i)) * spin * spin / 2;
  }
  return sum;
}

NeighbourCounts count_neighbours(const World& world, std::span<const Pair> touching) {
  const auto nd = static_cast<std::size_t>(world.disks.size());
  NeighbourCounts n;
  for (auto* counts : {&n.active, &n.broken, &n.initial, &n.initial_active, &n.touching, &n.loaded})
    counts->assign(nd, 0);
  const auto count = [&](std::vector<int>& counts, Pair pair) {
    const auto [a, b] = world.rows(pair);
    ++counts[static_cast<std::size_t>(a)];
    if (!is_wall(b)) ++counts[static_cast<std::size_t>(b)];
  };
  for (const Bond& bond : world.bonds.list) {
    const bool active = bond.state == BondState::active;
    count(active ? n.active : n.broken, bond.pair);
    if (active) count(n.loaded, bond.pair);
    if (bond.initial) count(n.initial, bond.pair);
    if (bond.initial && active) count(n.initial_active, bond.pair);
  }
  for (const Pair& pair : touching) count(n.touching, pair);
  for (const Contact& contact : world.contacts) {
    if (contact.impulse.x() <= 0) continue;
    const Bond* bond = world.bonds.find(contact.pair);
    if (!bond || bond->state != BondState::active) count(n.loaded, contact.pair);
  }
  return n;
}

NeighbourCounts count_neighbours(const World& world) {
  return count_neighbours(world, touching_pairs(world));
}

ContactCounts contact_counts(const World& world, const NeighbourCounts& neighbours) {
  ContactCounts counts;
  int grains = 0;
  for (int i = 0; i < world.disks.size(); ++i) {
    if (world.disks.role[i] != DiskRole::grain) continue;
    const auto k = static_cast<std::size_t>(i);
    ++grains;
    counts.touching += neighbours.touching[k];
    counts.loaded += neighbours.loaded[k];
    counts.bonded += neighbours.active[k];
    if (neighbours.touching[k] == 0) ++counts.without;
  }
  if (grains == 0) return counts;
  for (double* sum : {&counts.touching, &counts.loaded, &counts.bonded, &counts.without})
    *sum /= grains;
  return counts;
}

double volume_fraction(const World& world, double y_low, double y_high) {
  const double width = room_width(world).value_or(world.box.width);
  if (width <= 0 || y_high <= y_low) return 0;
  double area = 0;
  for (int i = 0; i < world.disks.size(); ++i) {
    const double y = world.disks.position[i].y();
    const double r = world.disks.radius[i];
    if (!world.shapes.find(i))
      area += disk_area_below(r, y_high - y) - disk_area_below(r, y_low - y);
  }
  for (const ShapedBody& shaped : world.shapes.bodies) {
    const std::vector<ConvexPart> parts = parts_in_place(world, shaped.body);
    area += area_below(parts, y_high) - area_below(parts, y_low);
  }
  return area / (width * (y_high - y_low));
}

WeightAbove weight_above_intruder(const World& world, const MeasureChoices& choices) {
  const int intruder = world.intruder();
  if (intruder < 0) return {};
  const double radius = half_width(world, intruder);
  const double reach = extent(world, intruder, {0, choices.above_begins < 0 ? -1.0 : 1.0});
  const double begins = world.disks.position[intruder].y() + choices.above_begins * reach;
  double all = 0;
  WeightAbove above;
  for (int i = 0; i < world.disks.size(); ++i) {
    if (world.disks.role[i] != DiskRole::grain) continue;
    const double mass = world.disks.mass[i];
    all += mass;
    if (world.disks.position[i].y() <= begins) continue;
    above.level += mass;
    if (std::abs(world.separation(intruder, i).x()) <= radius) above.column += mass;
  }
  if (all == 0) return {};
  return {above.column / all, above.level / all};
}

namespace {

// Of the pairs, those within this gap; `bonds`: the gaps of active bonds, whose range may be wider.
WithinGap within_gap(const World& world, std::span<const Pair> pairs, double gap,
                     std::int64_t grains, std::span<const double> bonds) {
  std::int64_t near = 0, ends = 0;
  const auto is_grain = [&](int body) {
    return !is_wall(body) && world.disks.role[world.row(body)] == DiskRole::grain;
  };
  for (const Pair& pair : pairs) {
    if (!world.movable(pair) || world.gap(pair) > gap) continue;
    ++near;
    ends += (is_grain(pair.a) ? 1 : 0) + (is_grain(pair.b) ? 1 : 0);
  }
  WithinGap found;
  if (grains > 0) found.coordination = static_cast<double>(ends) / static_cast<double>(grains);
  const auto bonded =
      std::ranges::count_if(bonds, [&](double bond_gap) { return bond_gap <= gap; });
  if (near > 0)
    found.active_bond_fraction = static_cast<double>(bonded) / static_cast<double>(near);
  return found;
}

}  // namespace

Sample measure(const World& world, const MeasureChoices& choices) {
  Sample s;
  s.time = world.time;
  s.step = world.step;
  s.energy = energies(world);
  s.grains = std::ranges::count(world.disks.role, DiskRole::grain);
  for (const Vec3& v : world.disks.velocity)
    s.max_speed = std::max(s.max_speed, v.head<2>().norm());
  s.packing_top = packing_top(world);
  if (room_width(world)) {
    const double bottom = packing_bottom(world);
    s.volume_fraction = volume_fraction(world, bottom, bottom + 0.7 * (s.packing_top - bottom));
  }

  // One search serves all margins of what counts as a contact.
  const std::vector<Pair> near = pairs_within(
      world,
      std::max(choices.contact_gap.value_or(widest_touching_gap(world)), kContactMargins.back()));
  std::vector<Pair> touching;
  std::ranges::copy_if(near, std::back_inserter(touching),
                       [&](Pair pair) { return touches(world, pair, choices.contact_gap); });
  const ContactCounts counts = contact_counts(world, count_neighbours(world, touching));
  s.coordination = counts.touching;
  s.coordination_loaded = counts.loaded;

  std::int64_t initial_active = 0;
  std::vector<double> bond_gaps;  // of active ones
  for (const Bond& bond : world.bonds.list) {
    if (bond.state != BondState::active) continue;
    ++s.bonds_active;
    bond_gaps.push_back(world.gap(bond.pair));
    initial_active += bond.initial ? 1 : 0;
  }
  for (std::size_t k = 0; k < s.within.size(); ++k)
    s.within[k] = within_gap(world, near, kContactMargins[k], s.grains, bond_gaps);
  s.contacts = std::ssize(touching);
  for (const Pair& pair : near) s.max_overlap = std::max(s.max_overlap, -world.gap(pair));
  if (s.contacts > 0)
    s.active_bond_fraction = static_cast<double>(s.bonds_active) / static_cast<double>(s.contacts);
  if (world.bonds.initial > 0)
    s.remaining_bond_fraction =
        static_cast<double>(initial_active) / static_cast<double>(world.bonds.initial);
  s.bonds_formed = world.bonds.formed;
  s.bonds_broken = world.bonds.broken;
  s.bonds_healed = world.bonds.healed;
  for (const Wall& wall : world.walls)
    if (wall.role == WallRole::piston) {
      s.piston_x = wall.point.x();
      s.piston_y = wall.point.y();
    }
  s.stress = mean_stress(world);
  s.fabric = fabric_of(world, touching);
  s.loads = wall_loads(world);
  if (const int intruder = world.intruder(); intruder >= 0) {
    s.has_intruder = true;
    s.intruder_position = world.disks.position[intruder];
    s.intruder_velocity = world.disks.velocity[intruder].head<2>();
    s.intruder_angle = world.disks.angle[intruder];
    s.reaction = reaction_on(world, intruder);
    s.resistance = s.reaction.force.y();
    s.depth = trajectory_so_far(world).surface - lowest_point(world, intruder);
    s.weight_above = weight_above_intruder(world, choices);
    s.around_intruder = around_intruder(world, touching, choices);
  }
  return s;
}

}  // namespace quicksand
