#include "core/linear/elimination.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <string>
#include <utility>

#include "core/base/memory.h"

namespace quicksand {

bool Elimination::analyse(int n, const std::vector<Edge>& edges, std::size_t bytes_of_slot) {
  if (n == n_ && edges == edges_) return false;
  try {
    plan(n, edges, bytes_of_slot);
  } catch (...) {
    n_ = -1;  // nothing is known of this graph
    throw;
  }
  return true;
}

void Elimination::plan(int n, const std::vector<Edge>& edges, std::size_t bytes_of_slot) {
  n_ = n;
  edges_ = edges;
  order();
  find_columns();
  find_supernodes();
  make_room(bytes_of_slot);
  find_targets();
  diagonal_slot_.resize(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) diagonal_slot_[i] = slot(position_[i], position_[i]);
  set_size(edge_slot_, edges.size());
  set_size(edge_flipped_, edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int p = position_[edges[e].i], q = position_[edges[e].j];
    edge_slot_[e] = slot(std::max(p, q), std::min(p, q));
    edge_flipped_[e] = p > q ? 1 : 0;
  }
}

void Elimination::order() {
  using Pattern = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * edges_.size() + static_cast<std::size_t>(n_));
  for (int i = 0; i < n_; ++i) entries.emplace_back(i, i, 1.0);
  for (const Edge& e : edges_) {
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

// A column passes its rows on to its parent, the first of them.
void Elimination::find_columns() {
  const auto size = static_cast<std::size_t>(n_);
  std::vector<std::vector<int>> below(size);
  for (const Edge& e : edges_) {
    const int p = position_[e.i], q = position_[e.j];
    below[std::min(p, q)].push_back(std::max(p, q));
  }
  constexpr int kNone = -1;
  std::vector<int> mark(size, kNone), last_child(size, kNone), sibling(size, kNone);
  column_start_.assign(size + 1, 0);
  column_row_.clear();
  for (int k = 0; k < n_; ++k) {
    mark[k] = k;
    const auto add = [&](int i) {
      if (mark[i] == k) return;
      mark[i] = k;
      append(column_row_, i);
    };
    for (int i : below[k]) add(i);
    // The first row of a child is this column itself.
    for (int j = last_child[k]; j != kNone; j = sibling[j])
      for (int q = column_start_[j] + 1; q < column_start_[j + 1]; ++q) add(column_row_[q]);
    const auto begin = column_row_.begin() + column_start_[k];
    std::sort(begin, column_row_.end());
    column_start_[k + 1] = static_cast<int>(column_row_.size());
    if (begin == column_row_.end()) continue;
    sibling[k] = last_child[*begin];
    last_child[*begin] = k;
  }
}

void Elimination::find_supernodes() {
  const auto rows_of = [&](int k) { return column_start_[k + 1] - column_start_[k]; };
  supernode_.clear();
  supernode_of_.resize(static_cast<std::size_t>(n_));
  row_.clear();
  for (int k = 0; k < n_; ++k) {
    const bool joins =
        k > 0 && rows_of(k - 1) == rows_of(k) + 1 && column_row_[column_start_[k - 1]] == k;
    if (joins) {
      Supernode& s = supernode_.back();
      ++s.columns;
      s.rows = rows_of(k);
      ++s.row;
    } else {
      append(supernode_,
             {.first = k, .columns = 1, .rows = rows_of(k), .row = static_cast<int>(row_.size())});
      row_.insert(row_.end(), column_row_.begin() + column_start_[k],
                  column_row_.begin() + column_start_[k + 1]);
    }
    supernode_of_[k] = static_cast<int>(supernode_.size()) - 1;
  }
}

// Of a dense packing in two dimensions the products of supernodes grow faster than the bodies: 42 a body at
// 2500, 92 at 90 000.
void Elimination::make_room(std::size_t bytes_of_slot) {
  std::size_t slots = 0, products = 0;
  for (const Supernode& s : supernode_) {
    const auto columns = static_cast<std::size_t>(s.columns),
               rows = static_cast<std::size_t>(s.rows);
    slots += (columns + rows) * columns;
    products += rows * (rows + 1) / 2;
  }
  const std::size_t more = products > target_.capacity() ? products - target_.capacity() : 0;
  const std::string problem =
      memory_problem(static_cast<double>(more) * sizeof(int) +
                     static_cast<double>(slots) * static_cast<double>(bytes_of_slot));
  if (!problem.empty())
    throw NotEnoughMemory("factorising the contacts of " + std::to_string(n_) + " bodies " +
                          problem + "; solver.method=gauss_seidel needs no factorisation");
  if (!std::in_range<int>(slots))
    throw NotEnoughMemory("factorising the contacts of " + std::to_string(n_) +
                          " bodies takes more blocks than are counted");
  if (more > 0) target_.reserve(products + products / 4);
  slots_ = static_cast<int>(slots);
  int offset = 0;
  for (Supernode& s : supernode_) {
    s.offset = offset;
    offset += (s.columns + s.rows) * s.columns;
  }
}

int Elimination::slot(int row, int column) const {
  const Supernode& s = supernode_[supernode_of_[column]];
  int i = row - s.first;
  if (i >= s.columns) {
    const int* below = rows(s);
    i = s.columns + static_cast<int>(std::lower_bound(below, below + s.rows, row) - below);
  }
  return s.offset + i * s.columns + column - s.first;
}

void Elimination::find_targets() {
  target_.clear();
  for (Supernode& from : supernode_) {
    from.target = static_cast<int>(target_.size());
    const int* row = rows(from);
    for (int p = 0; p < from.rows; ++p) {
      const Supernode& to = supernode_[supernode_of_[row[p]]];
      const int* below = rows(to);
      int place = 0;
      for (int q = p; q < from.rows; ++q) {
        int i = row[q] - to.first;
        if (i >= to.columns) {
          while (below[place] < row[q]) ++place;
          i = to.columns + place;
        }
        target_.push_back(to.offset + i * to.columns + row[p] - to.first);
      }
    }
  }
}

}  // namespace quicksand
