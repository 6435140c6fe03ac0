// Parts of a packing, and what is measured in each: bonds, contacts and coordination of its grains.
//
// A contact (or bond) counts for a region by the share of its grains that lie in it: by one or by a
// half between two grains, by one or not at all between a grain and a wall or the intruder. So regions
// that fill the packing add up to the whole, and no contact is lost at their borders.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/world/world.h"

namespace quicksand {

// What the model leaves open when regions and the weight above an intruder are measured.
struct MeasureChoices {
  // The channel: grains whose centres are nearer to where the intruder has passed (its centre, or the axis of a tall
  // body: distances_from_trajectory()) than its half width and this. At half a grain: those that stand, fell or were
  // pushed where the intruder passed. [d]
  double channel_margin = 0.5;
  // The intact region: grains farther from the trajectory than this. Where it lies, not what became of its
  // bonds, decides, so that a share of active bonds below one can show there; the other definition,
  // by the bonds, is by_bonds(). In the paper's box at F_c (one specimen, a straight trajectory assumed)
  // at least 0.99 of the initial bonds remain from 6 diameters on and 0.63 at 3 while the intruder is
  // half-way down; with it at the bottom and debris still falling no distance in that box is whole.
  // [widths of the intruder, of a disk its diameter]
  double intact_distance = 6;
  // What is above the intruder has its centre higher than this over the intruder's: 0 its centre, 1 its
  // top, -1 its lowest point. [ways from its centre to its top or, below 0, to its lowest point; radii of a disk]
  double above_begins = 0;
  // Pairs whose gap is at most this count as contacts; empty: what touching_pairs() says of each law. [d]
  std::optional<double> contact_gap;
};

struct Region {
  std::int64_t grains = 0;
  double contacts = 0;                         // touching now, by shares [1]
  double initial_bonds = 0;                    // by shares, whether active or broken [1]
  std::optional<double> coordination;          // touching neighbours of a grain; empty: no grains
  std::optional<double> active_bond_fraction;  // active bonds over contacts; empty: no contacts
  std::optional<double> remaining_bond_fraction;  // active initial bonds over initial; empty: none
};

// The regions 0 to `count` - 1, given the region of each disk (nd), where a negative number is none;
// intruders are in none, whatever their number. `touching` is touching_pairs(world).
std::vector<Region> regions_of(const World& world, std::span<const Pair> touching,
                               std::span<const int> region, int count);

struct AroundIntruder {
  Region channel, intact;
};
// Both empty where there is no intruder. A grain in both by the choices counts for the channel.
AroundIntruder around_intruder(const World& world, std::span<const Pair> touching,
                               const MeasureChoices& choices);

// The grains that have initial bonds, wherever they are: those whose bonds are all still active, intact by definition,
// and those that have lost at least one. The new contacts of both show in their share of active bonds and their
// coordination.
struct ByBonds {
  Region kept_all, lost_some;
};
ByBonds by_bonds(const World& world, std::span<const Pair> touching);

}  // namespace quicksand
