#include "core/linear/subtrees.h"

#include <algorithm>
#include <numeric>

namespace quicksand {

namespace {

constexpr int kSmall = 1500;  // columns below which all is top
constexpr int kGroups = 8;
// A subtree with more than this share of the work is split at its root.
constexpr double kShare = 1.0 / kGroups;

// Products of blocks.
double work_of(const Supernode& s) {
  const double columns = s.columns, rows = s.rows;
  return columns * (rows + columns / 2 + 1) * (rows + columns / 2 + 1);
}

// A supernode's parent has the first of its rows, and comes later; -1 of a root.
int parent(const Elimination& plan, const Supernode& s) {
  return s.rows > 0 ? plan.supernode_of(*plan.rows(s)) : -1;
}

// Of each supernode and all below it; `sum` is that of all.
std::vector<double> subtree_work(const Elimination& plan, double& sum) {
  const std::vector<Supernode>& node = plan.supernodes();
  std::vector<double> work(node.size(), 0);
  sum = 0;
  for (std::size_t s = 0; s < node.size(); ++s) {
    const double own = work_of(node[s]);
    sum += own;
    work[s] += own;
    if (const int p = parent(plan, node[s]); p >= 0) work[p] += work[s];
  }
  return work;
}

}  // namespace

void Subtrees::find(const Elimination& plan) {
  const std::vector<Supernode>& node = plan.supernodes();
  const std::size_t size = node.size();
  group_.clear();
  top_.clear();
  border_.clear();
  inside_.resize(size);
  for (std::size_t s = 0; s < size; ++s) inside_[s] = node[s].rows;
  part_.assign(size, 0);
  if (plan.size() < kSmall) {
    top_.resize(size);
    std::iota(top_.begin(), top_.end(), 0);
    return;
  }
  double sum = 0;
  const std::vector<double> work = subtree_work(plan, sum);
  constexpr int kTop = -1, kRoot = -2;
  std::vector<int> root(size);  // of the subtree a supernode is in
  std::vector<int> roots;
  for (std::size_t s = size; s-- > 0;) {
    const int p = parent(plan, node[s]);
    const int above = p < 0 ? kRoot : root[p];
    const bool under_top = above == kTop || above == kRoot;
    root[s] = !under_top ? above : work[s] > kShare * sum ? kTop : static_cast<int>(s);
    if (root[s] == static_cast<int>(s)) roots.push_back(root[s]);
  }
  // In the order of elimination: who goes through the bodies or contacts in that order and shares them out finds most of
  // them where their group is.
  std::ranges::sort(roots);
  double in_groups = 0;
  for (const int r : roots) in_groups += work[r];
  std::vector<int> group_of(size, kTop);
  double before = 0;
  for (const int r : roots) {
    group_of[r] = static_cast<int>(kGroups * (before + work[r] / 2) / in_groups);
    before += work[r];
  }
  group_.resize(kGroups);
  for (std::size_t s = 0; s < size; ++s) {
    part_[s] = root[s] == kTop ? kGroups : group_of[root[s]];
    if (root[s] == kTop) {
      top_.push_back(static_cast<int>(s));
      continue;
    }
    group_[part_[s]].push_back(static_cast<int>(s));
    // Rows are ancestors, the nearest first.
    const int* row = plan.rows(node[s]);
    const int* end = std::partition_point(
        row, row + node[s].rows, [&](int r) { return root[plan.supernode_of(r)] != kTop; });
    inside_[s] = static_cast<int>(end - row);
    if (inside_[s] < node[s].rows) border_.push_back(static_cast<int>(s));
  }
}

}  // namespace quicksand
