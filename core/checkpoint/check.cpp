#include "core/checkpoint/check.h"

#include <algorithm>
#include <cmath>

#include "core/measures/critical_force.h"
#include "core/measures/drive_result.h"

namespace quicksand {

namespace {

template <class... Numbers>
bool finite(Numbers... x) {
  return (std::isfinite(x) && ...);
}

template <class Vectors>
bool all_finite(const Vectors& vectors) {
  return std::ranges::all_of(vectors, [](const auto& v) { return v.allFinite(); });
}

bool not_negative(double x) { return std::isfinite(x) && x >= 0; }
bool positive(double x) { return std::isfinite(x) && x > 0; }

bool possible(const ContactLaw& law) {
  return not_negative(law.friction.value_or(0)) && not_negative(law.rolling_friction.value_or(0)) &&
         not_negative(law.cohesion_force.value_or(0)) && positive(law.cohesion_range);
}

bool possible(const Disks& d) {
  return all_finite(d.position) && all_finite(d.velocity) && all_finite(d.applied) &&
         std::ranges::all_of(d.angle, [](double x) { return std::isfinite(x); }) &&
         std::ranges::all_of(d.radius, positive) && std::ranges::all_of(d.mass, positive) &&
         std::ranges::all_of(d.inverse_mass,
                             [](const Vec3& m) { return m.allFinite() && m.minCoeff() >= 0; }) &&
         std::ranges::all_of(d.role, [](DiskRole role) { return role <= DiskRole::intruder; });
}

bool possible(const Wall& wall) {
  return wall.point.allFinite() && wall.velocity.allFinite() && wall.normal.allFinite() &&
         std::abs(wall.normal.norm() - 1) < 1e-9 && not_negative(wall.mass) && finite(wall.force) &&
         wall.role <= WallRole::piston;
}

// Corners part by part, each part of one body.
bool possible(const Shapes& shapes, const Disks& disks) {
  const auto nk = static_cast<int>(shapes.corners.size());
  for (int first = 0; first < nk;) {
    const Corner& part = shapes.corners[static_cast<std::size_t>(first)];
    if (part.count < 1 || part.count > nk - first || !shapes.find(part.body)) return false;
    for (int k = first; k < first + part.count; ++k) {
      const Corner& corner = shapes.corners[static_cast<std::size_t>(k)];
      if (corner.count != part.count || corner.body != part.body || !corner.place.allFinite() ||
          !positive(corner.radius))
        return false;
    }
    first += part.count;
  }
  return std::ranges::all_of(shapes.bodies, [&](const ShapedBody& shaped) {
    return shaped.body >= 0 && shaped.body < disks.size() && positive(shaped.inertia) &&
           not_negative(shaped.arm) && positive(shaped.radius);
  });
}

bool possible(const Bond& bond) { return bond.state <= BondState::broken; }

bool possible(const Contact& contact) {
  return contact.normal.allFinite() && contact.impulse.allFinite() &&
         finite(contact.gap, contact.cohesion);
}

// A search has its base, its targets are bodies of it, and a trial has a target.
bool possible(const Search& search) {
  const ForceBracket& bracket = search.bracket;
  if (search.kind > SearchKind::vane || (search.kind != SearchKind::none) != !!search.base)
    return false;
  if (!positive(bracket.first) || !not_negative(bracket.low) || !not_negative(bracket.held) ||
      bracket.trials < 0 || !positive(bracket.high.value_or(1)) || !not_negative(search.interval) ||
      !not_negative(search.force))
    return false;
  if (is_of_force(search.kind) && search.trial_runs && search.targets.empty()) return false;
  return std::ranges::all_of(search.targets, [&](const SearchTarget& target) {
    return target.body >= 0 && search.base && target.body < search.base->disks.size() &&
           finite(target.depth, target.weight_above);
  });
}

bool possible(const CriticalForce& found) {
  return found.phase >= 0 && is_of_force(found.kind) && found.position.allFinite() &&
         finite(found.depth, found.weight_above, found.force_low, found.force_high.value_or(0));
}

bool possible(const AdiabaticDeposit& sample) {
  return finite(sample.interval, sample.volume_fraction, sample.coordination,
                sample.change.value_or(0));
}

bool possible(const DriveResult& found) {
  return found.phase >= 0 && found.drive <= Drive::slide &&
         finite(found.peak.value_or(0), found.peak_at.value_or(0), found.residual.value_or(0),
                found.mean.value_or(0), found.way, found.normal_load.value_or(0),
                found.inertial_number.value_or(0)) &&
         (found.drive == Drive::slide || positive(found.radius)) && found.cleared >= 0;
}

template <class Item>
bool all_possible(const std::vector<Item>& items) {
  return std::ranges::all_of(items, [](const Item& item) { return possible(item); });
}

template <class Item>
bool pairs_in_order(const World& world, const std::vector<Item>& items) {
  const auto nd = world.disks.size();
  const auto nw = static_cast<int>(world.walls.size());
  const std::vector<Corner>& corners = world.shapes.corners;
  std::vector<char> begins_part(corners.size(), 0);
  world.shapes.for_each_part(
      [&](std::span<const Corner>, std::size_t first) { begins_part[first] = 1; });
  const auto is_corner = [&](int body, bool of_part) {
    if (is_disk(body) || is_wall(body)) return false;
    const auto k = static_cast<std::size_t>(body - kCornerBase);
    return k < corners.size() && (!of_part || begins_part[k]);
  };
  for (std::size_t k = 0; k < items.size(); ++k) {
    const auto [a, b] = items[k].pair;
    if (a < 0 || (a >= nd && !(is_corner(a, false) && is_wall(b)))) return false;
    if (is_wall(b) ? b - kWallBase >= nw : !is_corner(b, true) && (b <= a || b >= nd)) return false;
    if (k > 0 && !(items[k - 1].pair < items[k].pair)) return false;
  }
  return true;
}

bool possible(const LogHistogram& histogram) {
  return (histogram.counts.empty() || histogram.counts.size() == LogHistogram::kBins + 1) &&
         std::ranges::all_of(histogram.counts, [](std::int64_t n) { return n >= 0; });
}

const char* inconsistency(const World& world) {
  if (world.box.sides > Sides::walls || !not_negative(world.box.width) ||
      !finite(world.box.height) || (world.box.sides != Sides::open && world.box.width == 0))
    return "invalid box";
  if (world.gravity && !world.gravity->allFinite()) return "gravity is not a number";
  if (world.drag && !(not_negative(world.drag->linear) && not_negative(world.drag->quadratic)))
    return "invalid drag";
  if (!possible(world.grain_law) || !possible(world.wall_law) || !possible(world.intruder_law))
    return "invalid contact law";
  if (!possible(world.disks)) return "a disk has an invalid value";
  if (!possible(world.shapes, world.disks)) return "a shaped body has an invalid value";
  if (!all_possible(world.walls)) return "a wall has an invalid value";
  if (!all_possible(world.bonds.list) || !pairs_in_order(world, world.bonds.list))
    return "the bonds do not belong to these bodies";
  if (!all_possible(world.contacts) || !pairs_in_order(world, world.contacts))
    return "the contacts do not belong to these bodies";
  if (!all_finite(world.trajectory.places) || !finite(world.trajectory.surface))
    return "the intruder's trajectory has an invalid value";
  if (!finite(world.time) || !not_negative(world.impulse_dt)) return "a time is not a number";
  return nullptr;
}

}  // namespace

const char* inconsistency(const Checkpoint& checkpoint) {
  if (const char* problem = inconsistency(checkpoint.world)) return problem;
  const ProtocolState& protocol = checkpoint.protocol;
  if (protocol.search.base)
    if (const char* problem = inconsistency(*protocol.search.base)) return problem;
  if (protocol.phase < 0 ||
      !finite(protocol.phase_start, protocol.rest_since, protocol.trial_start))
    return "the protocol has no valid position";
  for (const auto& [name, number] : protocol.memory)
    if (!finite(number)) return "a stored value of the phase is not a number";
  const SweepErrors& errors = protocol.sweep_errors;
  if (!possible(errors.residual) || !possible(errors.bond_gap) || !possible(errors.penetration))
    return "invalid distribution of errors";
  if (!possible(protocol.search)) return "invalid search";
  if (is_of_force(protocol.search.kind) &&
      protocol.search.base->disks.size() != checkpoint.world.disks.size())
    return "the search is of other bodies";
  if (!all_possible(protocol.critical_forces) || !all_possible(protocol.adiabatic_deposits) ||
      !all_possible(protocol.drive_results))
    return "a result of a search is invalid";
  return nullptr;
}

}  // namespace quicksand
