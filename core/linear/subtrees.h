// Which supernodes of a factorisation can be eliminated at the same time.
//
// A supernode changes only those that its rows lie in, its ancestors in the elimination tree [Liu 1990]. So
// disjoint subtrees do not touch each other; they are gathered in groups of about equal work, which follow each other
// in the order of elimination. What is left are the ancestors of several of them, the top. In small systems all is top.
#pragma once

#include <vector>

#include "core/linear/elimination.h"

namespace quicksand {

class Subtrees {
 public:
  // Depends on the plan only, not on the number of threads.
  void find(const Elimination& plan);

  // Indices of supernodes, ascending.
  const std::vector<std::vector<int>>& groups() const { return group_; }
  const std::vector<int>& top() const { return top_; }
  // Those of the groups that have rows in the top.
  const std::vector<int>& border() const { return border_; }
  // The groups, and the top as the last part.
  int parts() const { return static_cast<int>(group_.size()) + 1; }
  int part_of_top() const { return static_cast<int>(group_.size()); }
  int part_of(int supernode) const { return part_[static_cast<std::size_t>(supernode)]; }
  // How many of its rows are in its group, or in the top if it is itself: the first ones.
  int rows_inside(int supernode) const { return inside_[static_cast<std::size_t>(supernode)]; }

 private:
  std::vector<std::vector<int>> group_;
  std::vector<int> top_, border_;
  std::vector<int> part_, inside_;  // (supernodes)
};

}  // namespace quicksand
