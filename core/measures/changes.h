// What happened to the grains of one specimen between two of its states.
#pragma once

#include <cstdint>
#include <vector>

#include "core/world/world.h"

namespace quicksand {

struct GrainChange {
  int grain = 0;            // row in Disks
  Vec2 displacement{0, 0};  // [d]
  double rotation = 0;      // counter-clockwise [rad]
  int bonds_broken = 0, bonds_formed = 0;
};

// Contacts and bonds count whatever bodies they join, but for bodies that only one of the states has.
struct Changes {
  static constexpr double kDisplaced = 0.5;  // [d]

  double duration = 0;           // [sqrt(d/g)]
  double mean_displacement = 0;  // of its length [d]
  double largest_displacement = 0;
  double mean_sinking = 0;        // downward [d]
  std::int64_t displaced = 0;     // grains, by more than kDisplaced
  std::int64_t bonds_broken = 0;  // active before, not active now
  std::int64_t bonds_formed = 0;  // active now, not active before
  std::int64_t contacts_lost = 0, contacts_gained = 0;
  std::vector<GrainChange> grains;  // those that are in both states
};

// Whether one of two states can have come from the other: the same box, and in each row that both have the same disk,
// with none taken away or replaced in between.
bool same_specimen(const World& before, const World& now);

// Both of the same specimen.
Changes changes_between(const World& before, const World& now);

}  // namespace quicksand
