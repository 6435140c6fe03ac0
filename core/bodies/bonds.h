// The memory of the bonds: which pairs are bonded, which were and are broken for good.
//
// A bond is formed at first touch while bonding is on. It is active until its gap passes the
// cohesion range; then it is broken and never comes back by itself: only healing restores it, or a
// touch in a phase that says that every touch does.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace quicksand {

// Two bodies, a < b. Disks are numbered from 0 and wall k is body kWallBase + k, so that disks can be
// added without renumbering the walls; a is a disk. In a pair of a shaped body (shapes.h) one of its corners stands for
// it: as b the first corner of the part that a disk touches, as a the one that touches a wall.
struct Pair {
  int a = 0;
  int b = 0;
  auto operator<=>(const Pair&) const = default;
};
constexpr int kWallBase = 1 << 30;
constexpr int kCornerBase = 1 << 29;
constexpr bool is_wall(int body) { return body >= kWallBase; }
constexpr bool is_disk(int body) { return body < kCornerBase; }
constexpr bool is_shaped(Pair pair) {
  return !is_disk(pair.a) || (!is_disk(pair.b) && !is_wall(pair.b));
}

enum class BondState : std::uint8_t { active, broken };

struct Bond {
  Pair pair;
  BondState state = BondState::active;
  bool initial = false;  // counted among the initial bonds (see Bonds::mark_initial)
  bool operator==(const Bond&) const = default;
};

struct Bonds {
  std::vector<Bond> list;   // sorted by pair
  std::int64_t formed = 0;  // since the beginning [1]
  std::int64_t broken = 0;  // since the beginning [1]
  std::int64_t healed = 0;  // made active by healing since the beginning, not counted in formed [1]
  std::int64_t initial = 0;  // number of bonds marked initial [1]

  Bond* find(Pair pair);
  const Bond* find(Pair pair) const { return const_cast<Bonds*>(this)->find(pair); }
  // Adds active bonds for these sorted pairs, none of which may be listed yet.
  void form(const std::vector<Pair>& pairs);
  // A broken bond, active again by a touch; counts as formed. Its initial mark stays as it is.
  void form_again(Bond& bond);
  // Makes the bonds of these sorted pairs, each once, active again; adds those that are not listed. None
  // may be active. Initial marks stay as they are, and new bonds have none.
  void heal(const std::vector<Pair>& pairs);
  // Marks the active bonds as the initial ones, and no others.
  void mark_initial();
};

}  // namespace quicksand
