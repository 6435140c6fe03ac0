#include "core/linear/elimination.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/core/graphs.h"

namespace quicksand {
namespace {

Elimination analysed(int n, const std::vector<Edge>& edges) {
  Elimination plan;
  plan.analyse(n, edges, 192);
  return plan;
}

TEST(Elimination, BodiesThatAllTouchAreOneSupernode) {
  std::vector<Edge> edges;
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < j; ++i) edges.push_back({i, j});
  const Elimination plan = analysed(9, edges);
  ASSERT_EQ(plan.supernodes().size(), 1U);
  EXPECT_EQ(plan.supernodes()[0].columns, 9);
  EXPECT_EQ(plan.slots(), 81);
  EXPECT_TRUE(plan.targets().empty());
}

// Of a chain, only the last two bodies have the same rows below them: none besides each other.
TEST(Elimination, AChainHasNoSupernodesToSpeakOf) {
  EXPECT_EQ(analysed(20, chain(20)).supernodes().size(), 19U);
}

TEST(Elimination, ADensePackingHasWideSupernodesAtItsEnd) {
  const Elimination plan = analysed(400, square_lattice(20));
  EXPECT_LT(plan.supernodes().size(), 350U);
  EXPECT_GT(plan.supernodes().back().columns, 8);
}

TEST(Elimination, EveryProductHasAPlaceOfItsOwnInALaterSupernode) {
  const Elimination plan = analysed(400, square_lattice(20));
  const int* target = plan.targets().data();
  int columns = 0;
  for (const Supernode& node : plan.supernodes()) {
    EXPECT_EQ(node.first, columns);
    columns += node.columns;
    std::set<int> taken;
    for (int p = 0; p < node.rows; ++p) {
      EXPECT_GE(plan.rows(node)[p], columns);
      if (p > 0) {
        EXPECT_GT(plan.rows(node)[p], plan.rows(node)[p - 1]);
      }
      for (int q = p; q < node.rows; ++q) taken.insert(*target++);
    }
    const auto pairs = static_cast<std::size_t>(node.rows * (node.rows + 1) / 2);
    ASSERT_EQ(taken.size(), pairs);
    if (taken.empty()) continue;
    EXPECT_GE(*taken.begin(), node.offset + (node.columns + node.rows) * node.columns);
    EXPECT_LT(*taken.rbegin(), plan.slots());
  }
  EXPECT_EQ(columns, 400);
  EXPECT_EQ(target, plan.targets().data() + plan.targets().size());
}

}  // namespace
}  // namespace quicksand
