// What is measured on a world. Fractions and numbers are [1], lengths [d], energies [F_g d].
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/forces/reaction.h"
#include "core/forces/stress.h"
#include "core/forces/wall_loads.h"
#include "core/measures/distributions.h"
#include "core/world/world.h"

namespace quicksand {

struct Energies {
  double kinetic = 0;  // of translation
  double rotational = 0;
  double potential = 0;  // in gravity, relative to the origin; 0 without gravity
};
Energies energies(const World& world);

// Pairs whose gap is at most the cohesion range of their law, or 5e-5 d without cohesion, at the present
// positions, whether a step was made or not; sorted. Not those of two immovable bodies, which neither bond nor carry.
// With `gap` [d], pairs of all laws up to it instead.
std::vector<Pair> touching_pairs(const World& world, std::optional<double> gap = std::nullopt);

// The largest gap up to which pairs of some law touch. [d]
double widest_touching_gap(const World& world);

// Counts for each disk (nd): active bonds, broken bonds, initial bonds, touching contacts, loaded
// contacts (compressed, or an active bond). Walls count as neighbours.
struct NeighbourCounts {
  std::vector<int> active, broken, initial, initial_active, touching, loaded;
};
NeighbourCounts count_neighbours(const World& world);
// The same, if touching_pairs(world) is known already.
NeighbourCounts count_neighbours(const World& world, std::span<const Pair> touching);

// Mean neighbours of a grain by what counts as a contact: any that touches, one that carries (compressed, or an
// active bond), an active bond; and the share of grains that touch nothing, which count in these means. Zeros
// without grains. [1]
struct ContactCounts {
  double touching = 0, loaded = 0, bonded = 0, without = 0;
};
ContactCounts contact_counts(const World& world, const NeighbourCounts& neighbours);

// Area of the disks and shaped bodies between two heights over that between the sides, clipped exactly: room_width(), or
// the box's width where it is unknown.
double volume_fraction(const World& world, double y_low, double y_high);

// Grains above the intruder, as a share of the weight of all grains [1]: straight above it, no farther
// to a side than its half width, and all that are higher. Zero where there is no intruder.
struct WeightAbove {
  double column = 0, level = 0;
};
WeightAbove weight_above_intruder(const World& world, const MeasureChoices& choices);

// Neighbours counted up to a wider gap than a bond's: a step that is not exact leaves true neighbours that far apart,
// so a number of contacts that depends on the margin says more of the method than of the packing.
struct WithinGap {
  double coordination = 0;  // mean number of neighbours of a grain within the gap
  std::optional<double> active_bond_fraction;  // active bonds over pairs within it; empty: no pairs
};
inline constexpr std::array kContactMargins{1e-3, 1e-2};  // [d]

struct Sample {
  double time = 0;
  std::int64_t step = 0;
  std::int64_t grains = 0;
  Energies energy;
  double max_speed = 0;    // of any disk's centre [sqrt(g d)]
  double packing_top = 0;  // [d]
  std::optional<double>
      volume_fraction;  // of the lower 70 % of the packing; empty: sides open, or a wall is tilted
  double coordination = 0;                        // mean number of touching neighbours of a grain
  double coordination_loaded = 0;                 // ... that carry a compressive force or a bond
  std::optional<double> active_bond_fraction;     // active bonds over contacts; empty: no contacts
  std::optional<double> remaining_bond_fraction;  // active initial bonds over initial; empty: none
  std::array<WithinGap, kContactMargins.size()> within;  // each of kContactMargins
  std::int64_t contacts = 0;
  std::int64_t bonds_active = 0;
  std::int64_t bonds_formed = 0;
  std::int64_t bonds_broken = 0;
  std::int64_t bonds_healed = 0;
  double max_overlap = 0;  // of any pair, two immovable bodies included [d]
  bool has_intruder = false;
  Vec2 intruder_position{0, 0};  // [d]
  Vec2 intruder_velocity{0, 0};  // [sqrt(g d)]
  double resistance = 0;         // upward force of its contacts [F_g]
  double intruder_angle = 0;     // turned since it was placed, counter-clockwise [rad]
  Reaction reaction;             // of its contacts
  double depth = 0;  // of its lowest point below the packing's top when it was placed [d]
  WeightAbove weight_above;
  AroundIntruder around_intruder;
  // Of the last piston: of its point, which has slid with it, and of its surface [d].
  std::optional<double> piston_x, piston_y;
  std::optional<Stress> stress;  // mean_stress()
  std::optional<Fabric> fabric;  // of the touching grains
  WallLoads loads;
};
Sample measure(const World& world, const MeasureChoices& choices = {});

}  // namespace quicksand
