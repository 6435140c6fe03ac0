// Pairs of bodies that are close: a hashed cell grid with periodic sides, and a list with a skin
// that is kept while nothing moved far. Memory is proportional to the number of pairs within
// the distance that is asked for, however far disks fly apart. Lists are sorted by pair, so that nothing depends on the search.
#pragma once

#include <vector>

#include "core/world/world.h"

namespace quicksand {

// All pairs (of disks, walls and parts of shaped bodies) whose gap is at most `distance` [d], sorted. Who is content with `enough`
// of them gets these and no more than a body has besides.
std::vector<Pair> pairs_within(const World& world, double distance,
                               std::size_t enough = static_cast<std::size_t>(-1));

// A list of all pairs with gaps up to a skin, rebuilt when bodies have moved too far for it.
class NeighborList {
 public:
  // Sorted pairs that contain all those with a gap up to `distance` [d].
  const std::vector<Pair>& pairs(const World& world, double distance);

 private:
  bool covers(const World& world, double distance) const;
  bool same_bodies(const World& world) const;
  void append_new_disks(const World& world);

  std::vector<Pair> pairs_;
  std::vector<Vec2> built_at_;  // (nd) positions when built
  std::vector<double> radius_;  // (nd)
  Shapes shapes_;
  std::vector<double> angle_;  // of the shaped bodies when built [rad]
  std::vector<Wall> walls_;    // (nw) when built
  Box box_;
  double skin_ = -1;
};

}  // namespace quicksand
