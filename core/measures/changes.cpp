#include "core/measures/changes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/measures/measures.h"

namespace quicksand {

namespace {

std::vector<Pair> active_pairs(const World& world) {
  std::vector<Pair> pairs;
  for (const Bond& bond : world.bonds.list)
    if (bond.state == BondState::active) pairs.push_back(bond.pair);
  return pairs;
}

bool has(const World& world, int body) {
  if (is_disk(body)) return body < world.disks.size();
  if (is_wall(body)) return body - kWallBase < std::ssize(world.walls);
  return body - kCornerBase < std::ssize(world.shapes.corners);
}

// Pairs of the first list that are not in the second, of bodies that the world of the second has, too.
std::vector<Pair> only_in(const std::vector<Pair>& first, const std::vector<Pair>& second,
                          const World& of_second) {
  std::vector<Pair> only;
  std::ranges::set_difference(first, second, std::back_inserter(only));
  std::erase_if(
      only, [&](const Pair& pair) { return !has(of_second, pair.a) || !has(of_second, pair.b); });
  return only;
}

int common_rows(const World& before, const World& now) {
  return std::min(before.disks.size(), now.disks.size());
}

std::vector<int> count_per_disk(const std::vector<Pair>& pairs, int rows) {
  std::vector<int> counts(static_cast<std::size_t>(rows), 0);
  for (const auto& [a, b] : pairs)
    for (const int body : {a, b})
      if (is_disk(body)) ++counts[static_cast<std::size_t>(body)];
  return counts;
}

}  // namespace

bool same_specimen(const World& before, const World& now) {
  constexpr double kStored = 1e-6;  // relative: histories keep radii in single precision
  if (before.specimen != now.specimen || before.box.width != now.box.width ||
      before.box.sides != now.box.sides)
    return false;
  for (int i = 0; i < common_rows(before, now); ++i) {
    const double radius = before.disks.radius[i];
    if (std::abs(now.disks.radius[i] - radius) > kStored * radius) return false;
    if (now.disks.role[i] != before.disks.role[i]) return false;
  }
  return true;
}

Changes changes_between(const World& before, const World& now) {
  const int rows = common_rows(before, now);
  const std::vector<Pair> bonds = active_pairs(before), bonds_now = active_pairs(now);
  const std::vector<Pair> touching = touching_pairs(before), touching_now = touching_pairs(now);
  const std::vector<Pair> broken = only_in(bonds, bonds_now, now);
  const std::vector<Pair> formed = only_in(bonds_now, bonds, before);
  const std::vector<int> broken_of = count_per_disk(broken, rows);
  const std::vector<int> formed_of = count_per_disk(formed, rows);
  Changes changes{.duration = now.time - before.time,
                  .bonds_broken = std::ssize(broken),
                  .bonds_formed = std::ssize(formed),
                  .contacts_lost = std::ssize(only_in(touching, touching_now, now)),
                  .contacts_gained = std::ssize(only_in(touching_now, touching, before))};
  for (int i = 0; i < rows; ++i) {
    if (now.disks.role[i] != DiskRole::grain) continue;
    const Vec2 displacement = now.disks.position[i] - before.disks.position[i];
    const double length = displacement.norm();
    changes.grains.push_back({.grain = i,
                              .displacement = displacement,
                              .rotation = now.disks.angle[i] - before.disks.angle[i],
                              .bonds_broken = broken_of[static_cast<std::size_t>(i)],
                              .bonds_formed = formed_of[static_cast<std::size_t>(i)]});
    changes.mean_displacement += length;
    changes.mean_sinking -= displacement.y();
    changes.largest_displacement = std::max(changes.largest_displacement, length);
    changes.displaced += length > Changes::kDisplaced ? 1 : 0;
  }
  if (const auto grains = static_cast<double>(changes.grains.size()); grains > 0) {
    changes.mean_displacement /= grains;
    changes.mean_sinking /= grains;
  }
  return changes;
}

}  // namespace quicksand
