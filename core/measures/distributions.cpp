#include "core/measures/distributions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/errors.h"
#include "core/measures/measures.h"
#include "core/world/extent.h"

namespace quicksand {

namespace {

constexpr double kPi = std::numbers::pi;
// No edge within the range is at 30, 45, 60, 90 or 120 degrees, where lattices have their angles and
// touching grains the least one: rounding would spread those over two bins.
constexpr int kAngleBins = 35;
constexpr int kBinsPerDecade = 10;

bool has_intruder(const World& world, Pair pair) {
  const auto [a, b] = world.rows(pair);
  return world.disks.role[a] == DiskRole::intruder ||
         (!is_wall(b) && world.disks.role[b] == DiskRole::intruder);
}

// Normal forces of the last step that `take` lets through, as it gives them.
template <class Take>
std::vector<double> normal_forces(const World& world, Take take) {
  std::vector<double> forces;
  if (world.impulse_dt == 0) return forces;
  for (const Contact& contact : world.contacts) {
    if (has_intruder(world, contact.pair)) continue;
    const std::optional<double> taken = take(contact, contact.normal_force(world.impulse_dt));
    if (taken) forces.push_back(*taken);
  }
  return forces;
}

// Directions of the active bonds of each disk, counter-clockwise from +x (nd) [rad].
std::vector<std::vector<double>> bond_directions(const World& world) {
  std::vector<std::vector<double>> directions(static_cast<std::size_t>(world.disks.size()));
  for (const Bond& bond : world.bonds.list) {
    if (bond.state != BondState::active) continue;
    Vec2 n;
    world.gap(bond.pair, &n);
    const auto [a, b] = world.rows(bond.pair);
    directions[static_cast<std::size_t>(a)].push_back(std::atan2(n.y(), n.x()));
    if (!is_wall(b)) directions[static_cast<std::size_t>(b)].push_back(std::atan2(-n.y(), -n.x()));
  }
  return directions;
}

}  // namespace

std::vector<double> Histogram::density() const {
  const std::int64_t all = std::accumulate(counts.begin(), counts.end(), below + above);
  std::vector<double> density(counts.size(), 0.0);
  for (std::size_t k = 0; k < counts.size() && all > 0; ++k)
    density[k] =
        static_cast<double>(counts[k]) / static_cast<double>(all) / (edges[k + 1] - edges[k]);
  return density;
}

std::vector<double> even_edges(double low, double high, int bins) {
  std::vector<double> edges;
  for (int k = 0; k <= bins; ++k) edges.push_back(low + (high - low) * k / bins);
  return edges;
}

std::vector<double> decade_edges(int low, int high, int bins_per_decade) {
  std::vector<double> edges;
  for (int k = 0; k <= (high - low) * bins_per_decade; ++k)
    edges.push_back(std::pow(10.0, low + static_cast<double>(k) / bins_per_decade));
  return edges;
}

Histogram histogram(std::span<const double> values, std::vector<double> edges) {
  Histogram h;
  h.edges = std::move(edges);
  h.counts.assign(h.edges.size() - 1, 0);
  for (const double value : values) {
    if (value < h.edges.front()) {
      ++h.below;
    } else if (value > h.edges.back()) {
      ++h.above;
    } else {
      const auto next = std::ranges::upper_bound(h.edges, value) - h.edges.begin();
      ++h.counts[std::min(static_cast<std::size_t>(next), h.counts.size()) - 1];
    }
  }
  return h;
}

Histogram bond_angles(const World& world, std::vector<double> edges) {
  std::vector<double> angles;
  const std::vector<std::vector<double>> all = bond_directions(world);
  for (int i = 0; i < world.disks.size(); ++i) {
    std::vector<double> around = all[static_cast<std::size_t>(i)];
    if (world.disks.role[i] != DiskRole::grain || around.size() < 2) continue;
    std::ranges::sort(around);
    if (around.size() == 2) {
      const double apart = around[1] - around[0];
      angles.push_back(std::min(apart, 2 * kPi - apart));
      continue;
    }
    around.push_back(around.front() + 2 * kPi);
    for (std::size_t k = 0; k + 1 < around.size(); ++k)
      if (const double apart = around[k + 1] - around[k]; apart <= kPi) angles.push_back(apart);
  }
  if (edges.empty()) edges = even_edges(0, kPi, kAngleBins);
  return histogram(angles, std::move(edges));
}

Histogram contact_orientations(const World& world, std::span<const Pair> touching) {
  std::vector<double> angles;
  for (const Pair& pair : touching) {
    if (!is_disk(pair.b) || has_intruder(world, pair)) continue;
    const Vec2 s = world.separation(pair.a, pair.b);
    angles.push_back(std::atan2(std::abs(s.y()), std::abs(s.x())));
  }
  return histogram(angles, even_edges(0, kPi / 2, kAngleBins));
}

std::optional<Fabric> fabric_of(const World& world, std::span<const Pair> touching) {
  // Of the angle a, the tensor holds the means of (1 + cos 2a)/2 and sin 2a / 2.
  Vec2 doubled{0, 0};
  int contacts = 0;
  for (const Pair& pair : touching) {
    if (!is_disk(pair.b) || has_intruder(world, pair)) continue;
    const Vec2 n = world.separation(pair.a, pair.b).normalized();
    doubled += Vec2(n.x() * n.x() - n.y() * n.y(), 2 * n.x() * n.y());
    ++contacts;
  }
  if (contacts == 0) return {};
  const double angle = std::atan2(doubled.y(), doubled.x()) / 2;
  return Fabric{doubled.norm() / contacts, angle < 0 ? angle + kPi : angle};
}

Histogram contact_forces(const World& world) {
  std::vector<double> forces =
      normal_forces(world, [](const Contact&, double force) -> std::optional<double> {
        if (force > 0) return force;
        return {};
      });
  const double mean = std::accumulate(forces.begin(), forces.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(1, forces.size()));
  for (double& force : forces) force /= mean;
  return histogram(forces, decade_edges(-4, 2, kBinsPerDecade));
}

Histogram bond_tensions(const World& world) {
  const std::vector<double> tensions =
      normal_forces(world, [&](const Contact& contact, double force) -> std::optional<double> {
        // A bond that broke in the step holds no more, and gave less than its cohesion force.
        const Bond* bond = world.bonds.find(contact.pair);
        const bool held = bond && bond->state == BondState::active && contact.cohesion > 0;
        if (held && force < 0) return -force / contact.cohesion;
        return {};
      });
  return histogram(tensions, decade_edges(-7, 0, kBinsPerDecade));
}

std::vector<Slice> height_profile(const World& world, std::span<const Pair> touching,
                                  double thickness) {
  const double highest = packing_top(world), bottom = packing_bottom(world);
  if (highest <= bottom || !std::isfinite(highest)) return {};
  const double first = std::floor(bottom / thickness), last = std::ceil(highest / thickness);
  constexpr double kMostSlices = 10000;
  if (last - first > kMostSlices) throw InputError("slices", "would be more than 10000");
  const int count = static_cast<int>(last - first);

  // What rounding puts outside belongs to the slice at the end.
  std::vector<int> slice_of;
  for (const Vec2& p : world.disks.position)
    slice_of.push_back(static_cast<int>(
        std::clamp(std::floor(p.y() / thickness) - first, 0.0, static_cast<double>(count - 1))));
  const std::vector<Region> grains = regions_of(world, touching, slice_of, count);
  std::vector<Stress> stress(static_cast<std::size_t>(count));
  const std::vector<Stress> of_body = stress_times_area(world);
  for (std::size_t i = 0; i < of_body.size(); ++i)
    if (world.disks.role[static_cast<int>(i)] == DiskRole::grain)
      stress[static_cast<std::size_t>(slice_of[i])] += of_body[i];
  const std::optional<double> width = room_width(world);
  std::vector<Slice> slices;
  for (int k = 0; k < count; ++k) {
    Slice slice{(first + k) * thickness,
                (first + k + 1) * thickness,
                {},
                grains[static_cast<std::size_t>(k)],
                {}};
    // There is nothing below the floor or the lowest grain.
    const bool cut = slice.low < bottom;
    if (cut) slice.low = bottom;
    const double height = cut ? slice.high - slice.low : thickness;
    if (world.box.sides != Sides::open)
      slice.volume_fraction = volume_fraction(world, slice.low, slice.high);
    if (width) slice.stress = stress[static_cast<std::size_t>(k)].over(*width * height);
    slices.push_back(slice);
  }
  return slices;
}

}  // namespace quicksand
