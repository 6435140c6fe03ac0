#include "core/measures/regions.h"

#include <algorithm>

#include "core/world/intruder_trajectory.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

// Sums over a region. Contacts and bonds count twice their share, so that all are whole numbers.
struct Sums {
  std::int64_t grains = 0, neighbours = 0, contacts = 0, active = 0, initial = 0, remaining = 0;
};

std::optional<double> ratio(std::int64_t part, std::int64_t whole) {
  if (whole == 0) return {};
  return static_cast<double>(part) / static_cast<double>(whole);
}

Region region_from(const Sums& sums) {
  return {.grains = sums.grains,
          .contacts = static_cast<double>(sums.contacts) / 2,
          .initial_bonds = static_cast<double>(sums.initial) / 2,
          .coordination = ratio(sums.neighbours, sums.grains),
          .active_bond_fraction = ratio(sums.active, sums.contacts),
          .remaining_bond_fraction = ratio(sums.remaining, sums.initial)};
}

}  // namespace

std::vector<Region> regions_of(const World& world, std::span<const Pair> touching,
                               std::span<const int> region, int count) {
  std::vector<Sums> sums(static_cast<std::size_t>(count));
  const auto is_grain = [&](int body) {
    return is_disk(body) && world.disks.role[body] == DiskRole::grain;
  };
  // Calls add(sums, twice the share) for the region of each grain of a pair.
  const auto share_out = [&](Pair pair, auto add) {
    const bool both = is_grain(pair.a) && is_grain(pair.b);
    for (const int body : {pair.a, pair.b}) {
      if (!is_grain(body)) continue;
      const int index = region[static_cast<std::size_t>(body)];
      if (index >= 0) add(sums[static_cast<std::size_t>(index)], both ? 1 : 2);
    }
  };
  for (int i = 0; i < world.disks.size(); ++i) {
    const int index = region[static_cast<std::size_t>(i)];
    if (index >= 0 && is_grain(i)) ++sums[static_cast<std::size_t>(index)].grains;
  }
  for (const Pair& pair : touching)
    share_out(pair, [](Sums& s, int share) { s.contacts += share, ++s.neighbours; });
  for (const Bond& bond : world.bonds.list) {
    const bool active = bond.state == BondState::active;
    share_out(bond.pair, [&](Sums& s, int share) {
      if (active) s.active += share;
      if (bond.initial) s.initial += share;
      if (bond.initial && active) s.remaining += share;
    });
  }
  std::vector<Region> regions;
  std::ranges::transform(sums, std::back_inserter(regions), region_from);
  return regions;
}

AroundIntruder around_intruder(const World& world, std::span<const Pair> touching,
                               const MeasureChoices& choices) {
  const int intruder = world.intruder();
  if (intruder < 0) return {};
  const double radius = half_width(world, intruder);
  const double channel = radius + choices.channel_margin;
  const double intact = 2 * radius * choices.intact_distance;
  const std::vector<double> distances = distances_from_trajectory(world, std::max(channel, intact));
  std::vector<int> region;
  std::ranges::transform(distances, std::back_inserter(region), [&](double distance) {
    return distance < channel ? 0 : distance >= intact ? 1 : -1;
  });
  const std::vector<Region> both = regions_of(world, touching, region, 2);
  return {both[0], both[1]};
}

ByBonds by_bonds(const World& world, std::span<const Pair> touching) {
  constexpr int kNone = -1, kKept = 0, kLost = 1;
  std::vector<int> region(static_cast<std::size_t>(world.disks.size()), kNone);
  for (const Bond& bond : world.bonds.list) {
    if (!bond.initial) continue;
    for (const int body : {bond.pair.a, bond.pair.b}) {
      if (!is_disk(body)) continue;
      int& known = region[static_cast<std::size_t>(body)];
      if (bond.state == BondState::broken)
        known = kLost;
      else if (known == kNone)
        known = kKept;
    }
  }
  const std::vector<Region> both = regions_of(world, touching, region, 2);
  return {both[0], both[1]};
}

}  // namespace quicksand
