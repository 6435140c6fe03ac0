#include "core/linear/subtrees.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/support/core/graphs.h"

namespace quicksand {
namespace {

struct Found {
  Elimination plan;
  Subtrees subtrees;
  std::map<int, int> group;  // of a supernode; kTop
  static constexpr int kTop = -1;
};

Found found(int n, const std::vector<Edge>& edges) {
  Found f;
  f.plan.analyse(n, edges, 192);
  f.subtrees.find(f.plan);
  for (std::size_t g = 0; g < f.subtrees.groups().size(); ++g)
    for (const int s : f.subtrees.groups()[g]) f.group.emplace(s, static_cast<int>(g));
  for (const int s : f.subtrees.top()) f.group.emplace(s, Found::kTop);
  return f;
}

TEST(Subtrees, OfASmallSystemAreNotSought) {
  const Found f = found(400, square_lattice(20));
  EXPECT_TRUE(f.subtrees.groups().empty());
  EXPECT_EQ(f.subtrees.top().size(), f.plan.supernodes().size());
}

// So that groups can be eliminated at the same time, and only the border touches what is above.
TEST(Subtrees, NoGroupHasRowsInAnother) {
  for (const auto& [n, edges] :
       {std::pair{2500, square_lattice(50)}, std::pair{4000, chain(4000)}}) {
    const Found f = found(n, edges);
    ASSERT_EQ(f.group.size(), f.plan.supernodes().size());
    std::size_t border = 0;
    for (const auto& [s, group] : f.group) {
      const Supernode& node = f.plan.supernodes()[static_cast<std::size_t>(s)];
      const int inside = f.subtrees.rows_inside(s);
      for (int p = 0; p < node.rows; ++p)
        EXPECT_EQ(f.group.at(f.plan.supernode_of(f.plan.rows(node)[p])),
                  p < inside ? group : Found::kTop);
      if (inside < node.rows) ++border;
    }
    EXPECT_EQ(f.subtrees.border().size(), border);
    EXPECT_TRUE(std::ranges::is_sorted(f.subtrees.border()));
    EXPECT_TRUE(std::ranges::is_sorted(f.subtrees.top()));
  }
}

// A subtree has at most an eighth of the work, and its middle decides on the group, of eight.
TEST(Subtrees, GroupsFollowEachOtherWithAtMostTwiceTheirShare) {
  const Found f = found(10000, square_lattice(100));
  ASSERT_GE(f.subtrees.groups().size(), 2U);
  double most = 0, sum = 0;
  int last = -1;
  for (const auto& group : f.subtrees.groups()) {
    double work = 0;
    for (const int s : group) {
      const Supernode& node = f.plan.supernodes()[static_cast<std::size_t>(s)];
      work += node.columns * std::pow(node.rows + node.columns / 2.0 + 1, 2);
    }
    most = std::max(most, work);
    sum += work;
    if (group.empty()) continue;
    EXPECT_GT(group.front(), last);
    last = group.back();
  }
  EXPECT_LE(most, 2 * sum / static_cast<double>(f.subtrees.groups().size()));
}

TEST(Subtrees, EverySupernodeIsInThePartOfItsGroupOrInTheTop) {
  for (const int side : {20, 50}) {
    const Found f = found(side * side, square_lattice(side));
    for (const auto& [s, group] : f.group)
      EXPECT_EQ(f.subtrees.part_of(s), group == Found::kTop ? f.subtrees.parts() - 1 : group);
  }
}

}  // namespace
}  // namespace quicksand
