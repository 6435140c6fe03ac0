#include "core/block_lu.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/memory.h"

namespace quicksand {

namespace {

// Inverse by elimination with row pivoting. A pivot block holds stiffnesses from 1 to 1e7: cofactors
// would lose the soft directions. Flips `negative` if the determinant is below zero.
Mat3 inverse(Mat3 a, bool& negative) {
  Mat3 b = Mat3::Identity();
  for (int k = 0; k < 3; ++k) {
    int best = k;
    for (int i = k + 1; i < 3; ++i)
      if (std::abs(a(i, k)) > std::abs(a(best, k))) best = i;
    if (best != k) {
      negative = !negative;
      a.row(k).swap(a.row(best));
      b.row(k).swap(b.row(best));
    }
    const double pivot = 1 / a(k, k);
    if (pivot < 0) negative = !negative;
    a.row(k) *= pivot;
    b.row(k) *= pivot;
    for (int i = 0; i < 3; ++i) {
      if (i == k) continue;
      const double factor = a(i, k);
      a.row(i) -= factor * a.row(k);
      b.row(i) -= factor * b.row(k);
    }
  }
  return b;
}

// c -= a b
void subtract_product(Mat3& c, const Mat3& a, const Mat3& b) { c -= a.lazyProduct(b); }

}  // namespace

void BlockLu::analyse(int n, const std::vector<Edge>& edges) {
  if (n == n_ && edges == edges_) return;
  n_ = n;
  edges_ = edges;
  order(edges);
  find_structure(edges);
  const auto size = static_cast<std::size_t>(n);
  pivot_.resize(size);
  lower_.resize(row_.size());
  upper_.resize(row_.size());
  work_.resize(size);
}

void BlockLu::order(const std::vector<Edge>& edges) {
  using Pattern = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * edges.size() + static_cast<std::size_t>(n_));
  for (int i = 0; i < n_; ++i) entries.emplace_back(i, i, 1.0);
  for (const Edge& e : edges) {
    entries.emplace_back(e.i, e.j, 1.0);
    entries.emplace_back(e.j, e.i, 1.0);
  }
  Pattern pattern(n_, n_);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(pattern, permutation);
  // AMDOrdering gives the row that comes k-th.
  position_.resize(static_cast<std::size_t>(n_));
  for (int k = 0; k < n_; ++k) position_[permutation.indices()[k]] = k;
}

void BlockLu::find_structure(const std::vector<Edge>& edges) {
  const auto size = static_cast<std::size_t>(n_);
  std::vector<std::vector<int>> below(size);
  for (const Edge& e : edges) {
    const int p = position_[e.i], q = position_[e.j];
    below[std::min(p, q)].push_back(std::max(p, q));
  }
  // A column passes its rows on to its parent, the first of them.
  std::vector<int> mark(size, -1);
  std::vector<std::vector<int>> children(size);
  start_.assign(size + 1, 0);
  row_.clear();
  std::vector<int> column;
  for (int k = 0; k < n_; ++k) {
    column.clear();
    mark[k] = k;
    const auto add = [&](int i) {
      if (mark[i] == k) return;
      mark[i] = k;
      column.push_back(i);
    };
    for (int i : below[k]) add(i);
    for (int j : children[k])
      for (int q = start_[j]; q < start_[j + 1]; ++q)
        if (row_[q] > k) add(row_[q]);
    std::ranges::sort(column);
    row_.insert(row_.end(), column.begin(), column.end());
    start_[k + 1] = static_cast<int>(row_.size());
    if (!column.empty()) children[column.front()].push_back(k);
  }
  // Where the products of a column's rows go: entry (i, j) with j < i of column k adds to row i of
  // column j.
  const auto slot = [&](int row, int of_column) {
    const auto first = row_.begin() + start_[of_column];
    const auto last = row_.begin() + start_[of_column + 1];
    return static_cast<int>(std::lower_bound(first, last, row) - row_.begin());
  };
  make_room();
  target_.clear();
  for (int k = 0; k < n_; ++k)
    for (int q = start_[k]; q < start_[k + 1]; ++q)
      for (int p = start_[k]; p < q; ++p) target_.push_back(slot(row_[q], row_[p]));
  edge_slot_.resize(edges.size());
  edge_flipped_.resize(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int p = position_[edges[e].i], q = position_[edges[e].j];
    edge_slot_[e] = slot(std::max(p, q), std::min(p, q));
    edge_flipped_[e] = p > q ? 1 : 0;
  }
}

// In two dimensions the products grow as n^1.5: a dense packing of a million bodies has ten thousand a body.
void BlockLu::make_room() {
  std::size_t products = 0;
  for (std::size_t k = 0; k + 1 < start_.size(); ++k) {
    const auto rows = static_cast<std::size_t>(start_[k + 1] - start_[k]);
    products += rows * (rows - 1) / 2;
  }
  const auto bytes = [](const auto& held, std::size_t needed) {
    const std::size_t more = needed > held.capacity() ? needed - held.capacity() : 0;
    return static_cast<double>(more) * sizeof(held[0]);
  };
  const std::string problem = memory_problem(bytes(target_, products) + bytes(lower_, row_.size()) +
                                             bytes(upper_, row_.size()));
  if (!problem.empty()) {
    const int bodies = n_;
    n_ = -1;  // nothing is known of this graph
    throw NotEnoughMemory("to factorise the contacts of " + std::to_string(bodies) + " bodies " +
                          problem + "; solver.method=gauss_seidel does without");
  }
  if (products > target_.capacity()) target_.reserve(products + products / 4);
}

void BlockLu::clear() {
  std::ranges::fill(pivot_, Mat3::Zero());
  std::ranges::fill(lower_, Mat3::Zero());
  std::ranges::fill(upper_, Mat3::Zero());
}

double BlockLu::operations() const {
  constexpr double kProduct = 45, kSubtracted = 54, kInverse = 90;  // of 3x3 blocks
  return n_ * kInverse + static_cast<double>(row_.size()) * (kProduct + kSubtracted) +
         static_cast<double>(target_.size()) * 2 * kSubtracted;
}

void BlockLu::factorise() {
  negative_ = false;
  const int* target = target_.data();
  for (int k = 0; k < n_; ++k) {
    const Mat3 pivot = inverse(pivot_[k], negative_);
    pivot_[k] = pivot;
    const int first = start_[k], last = start_[k + 1];
    for (int q = first; q < last; ++q) {
      const Mat3 l = lower_[q].lazyProduct(pivot);
      const Mat3 u = upper_[q];
      lower_[q] = l;
      subtract_product(pivot_[row_[q]], l, u);
      // The rows before this one are scaled already, this one's products with them are due.
      for (int p = first; p < q; ++p) {
        const int t = *target++;
        subtract_product(lower_[t], l, upper_[p]);
        subtract_product(upper_[t], lower_[p], u);
      }
    }
  }
}

void BlockLu::solve(std::vector<Vec3>& x) {
  for (int i = 0; i < n_; ++i) work_[position_[i]] = x[i];
  for (int k = 0; k < n_; ++k)
    for (int q = start_[k]; q < start_[k + 1]; ++q)
      work_[row_[q]] -= lower_[q].lazyProduct(work_[k]);
  for (int k = n_ - 1; k >= 0; --k) {
    Vec3 sum = work_[k];
    for (int q = start_[k]; q < start_[k + 1]; ++q) sum -= upper_[q].lazyProduct(work_[row_[q]]);
    work_[k] = pivot_[k].lazyProduct(sum);
  }
  for (int i = 0; i < n_; ++i) x[i] = work_[position_[i]];
}

}  // namespace quicksand
