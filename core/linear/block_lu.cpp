#include "core/linear/block_lu.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/lanes.h"
#include "core/base/memory.h"
#include "core/base/parallel.h"

namespace quicksand {

namespace {

constexpr int kWorthSharing = 2000;  // products of blocks

// Columns by name and not in an array: the compiler keeps them in registers then.
struct LoadedBlock {
  Lanes x, y, z;
};

[[gnu::always_inline]] inline void load_block(const PaddedBlock& from, LoadedBlock& block) {
  load_lanes(from.column[0], block.x);
  load_lanes(from.column[1], block.y);
  load_lanes(from.column[2], block.z);
}
[[gnu::always_inline]] inline void store_block(const LoadedBlock& block, PaddedBlock& to) {
  store_lanes(block.x, to.column[0]);
  store_lanes(block.y, to.column[1]);
  store_lanes(block.z, to.column[2]);
}

// y := a x
[[gnu::always_inline]] inline void multiply(const LoadedBlock& a, const double* x, Lanes& y) {
  y = a.x * x[0] + a.y * x[1] + a.z * x[2];
}

// y -= a x
[[gnu::always_inline]] inline void subtract_product(const PaddedBlock& a, const double* x,
                                                    Lanes& y) {
  LoadedBlock factor;
  load_block(a, factor);
  Lanes product;
  multiply(factor, x, product);
  y -= product;
}

// a := a b
[[gnu::always_inline]] inline void multiply_by(const PaddedBlock& b, PaddedBlock& a) {
  LoadedBlock factor, product;
  load_block(a, factor);
  multiply(factor, b.column[0], product.x);
  multiply(factor, b.column[1], product.y);
  multiply(factor, b.column[2], product.z);
  store_block(product, a);
}

// c -= sum of a[k] b[k]
[[gnu::always_inline]] inline void subtract_products(const PaddedBlock* a, const PaddedBlock* b,
                                                     int count, PaddedBlock& c) {
  LoadedBlock sum;
  load_block(c, sum);
  for (int k = 0; k < count; ++k) {
    LoadedBlock factor, product;
    load_block(a[k], factor);
    multiply(factor, b[k].column[0], product.x);
    multiply(factor, b[k].column[1], product.y);
    multiply(factor, b[k].column[2], product.z);
    sum.x -= product.x;
    sum.y -= product.y;
    sum.z -= product.z;
  }
  store_block(sum, c);
}

// One step of the elimination in place: with pivot (k, k), column k is the next to be replaced.
[[gnu::always_inline]] inline void eliminate(int k, Lanes& pivot_column, Lanes& beside,
                                             Lanes& farther) {
  const double per_pivot = 1 / pivot_column[k], b = beside[k] * per_pivot,
               f = farther[k] * per_pivot;
  beside -= b * pivot_column;
  farther -= f * pivot_column;
  pivot_column *= -per_pivot;
  beside[k] = b, farther[k] = f, pivot_column[k] = per_pivot;
}

// The same with the rows in an order in which each pivot is the largest left in its column.
void invert_pivoted(PaddedBlock& block, bool& negative) {
  const Eigen::PartialPivLU<Mat3> lu(block.entry());
  negative = negative != (lu.determinant() < 0);
  block.entry() = lu.inverse();
}

// Inverts by elimination. A pivot block holds impedances from 1 to 1e7: cofactors would lose the soft directions.
// Where contacts stick it is symmetric and positive, and its own order will do; rows are exchanged where a pivot falls
// behind what is below it. Flips `negative` if the determinant is below zero.
[[gnu::always_inline]] inline void invert(PaddedBlock& block, bool& negative) {
  constexpr double kBehind = 0.1;
  LoadedBlock a;
  load_block(block, a);
  const double first = a.x[0];
  const bool first_leads = kBehind * std::max(std::abs(a.x[1]), std::abs(a.x[2])) <= first;
  eliminate(0, a.x, a.y, a.z);
  const double second = a.y[1];
  const bool second_leads = kBehind * std::abs(a.y[2]) <= second;
  eliminate(1, a.y, a.x, a.z);
  const double third = a.z[2];
  if (!(first_leads && second_leads && first > 0 && second > 0 && third > 0))
    return invert_pivoted(block, negative);
  eliminate(2, a.z, a.x, a.y);
  store_block(a, block);
}

// The columns of one supernode, as a dense trapezoid.
[[gnu::always_inline]] inline void factorise_columns(const Supernode& node, PaddedBlock* lower,
                                                     PaddedBlock* upper, bool& negative) {
  const int s = node.columns, m = s + node.rows;
  for (int j = 0; j < s; ++j) {
    if (j > 0)
      for (int i = j; i < m; ++i)
        subtract_products(lower + i * s, upper + j * s, j, lower[i * s + j]);
    PaddedBlock& pivot = lower[j * s + j];
    invert(pivot, negative);
    for (int i = j + 1; i < m; ++i) {
      if (j > 0) subtract_products(lower + j * s, upper + i * s, j, upper[i * s + j]);
      multiply_by(pivot, lower[i * s + j]);
    }
  }
}

// What the row `p` of a supernode adds to the column of its number.
[[gnu::always_inline]] inline void pass_on(const Elimination& plan, const Supernode& node, int p,
                                           PaddedBlock* all_lower, PaddedBlock* all_upper) {
  const int s = node.columns;
  const PaddedBlock* lower = all_lower + node.offset + s * s;
  const PaddedBlock* upper = all_upper + node.offset + s * s;
  const int* target = plan.targets().data() + node.target + p * node.rows - p * (p - 1) / 2;
  subtract_products(lower + p * s, upper + p * s, s, all_lower[*target]);
  for (int q = p + 1; q < node.rows; ++q) {
    const int t = *++target;
    subtract_products(lower + q * s, upper + p * s, s, all_lower[t]);
    subtract_products(lower + p * s, upper + q * s, s, all_upper[t]);
  }
}

// x of rows `first` to `last` of a supernode, counted from its first column, less what its columns give.
[[gnu::always_inline]] inline void solve_lower(const Elimination& plan, const Supernode& node,
                                               int first, int last, const PaddedBlock* all_lower,
                                               Eigen::Vector4d* x) {
  const int s = node.columns;
  const PaddedBlock* lower = all_lower + node.offset;
  const int* row = plan.rows(node);
  for (int i = first; i < last; ++i) {
    double* to = x[i < s ? node.first + i : row[i - s]].data();
    Lanes y;
    load_lanes(to, y);
    for (int j = 0; j < std::min(i, s); ++j)
      subtract_product(lower[i * s + j], x[node.first + j].data(), y);
    store_lanes(y, to);
  }
}

[[gnu::always_inline]] inline void solve_upper(const Elimination& plan, const Supernode& node,
                                               const PaddedBlock* all_lower,
                                               const PaddedBlock* all_upper, Eigen::Vector4d* x) {
  const int s = node.columns, m = s + node.rows;
  const PaddedBlock* lower = all_lower + node.offset;
  const PaddedBlock* upper = all_upper + node.offset;
  const int* row = plan.rows(node);
  for (int j = s - 1; j >= 0; --j) {
    double* to = x[node.first + j].data();
    Lanes y;
    load_lanes(to, y);
    for (int i = j + 1; i < m; ++i)
      subtract_product(upper[i * s + j], x[i < s ? node.first + i : row[i - s]].data(), y);
    store_lanes(y, to);
    LoadedBlock inverse;
    load_block(lower[j * s + j], inverse);
    multiply(inverse, to, y);
    store_lanes(y, to);
  }
}

// work(part) for parts that may run at the same time, compiled like with_lanes().
template <class Work>
void share_in_lanes(std::size_t parts, const Work& work) {
  share_parts(static_cast<int>(parts),
              [&](int part) { with_lanes([&]() __attribute__((always_inline)) { work(part); }); });
}

}  // namespace

void BlockLu::analyse(int n, const std::vector<Edge>& edges) {
  ready_ = !plan_.analyse(n, edges, 2 * sizeof(PaddedBlock)) && ready_;
  if (ready_) return;
  subtrees_.find(plan_);
  set_size(lower_, static_cast<std::size_t>(plan_.slots()));
  set_size(upper_, lower_.size());
  ready_ = true;
}

// Supernodes that follow each other do so in memory.
void BlockLu::clear(const std::vector<int>& supernodes) {
  const std::vector<Supernode>& node = plan_.supernodes();
  for (std::size_t k = 0; k < supernodes.size();) {
    const int begin = node[supernodes[k]].offset;
    int last = supernodes[k];
    while (++k < supernodes.size() && supernodes[k] == last + 1) ++last;
    const int end = node[last].offset + (node[last].columns + node[last].rows) * node[last].columns;
    std::fill(lower_.data() + begin, lower_.data() + end, PaddedBlock{});
    std::fill(upper_.data() + begin, upper_.data() + end, PaddedBlock{});
  }
}

double BlockLu::operations() const {
  constexpr double kProduct = 45, kSubtracted = 54, kInverse = 90;  // of 3x3 blocks
  double sum = 0;
  for (const Supernode& node : plan_.supernodes())
    for (int k = 0; k < node.columns; ++k) {
      const double rows = node.rows + node.columns - 1 - k;
      sum += kInverse + kProduct * rows + kSubtracted * rows * rows;
    }
  return sum;
}

void BlockLu::factorise(const std::function<void(int)>& fill) {
  const std::vector<Supernode>& node = plan_.supernodes();
  PaddedBlock *lower = lower_.data(), *upper = upper_.data();
  const int threads = usable_threads();
  flipped_.assign(subtrees_.groups().size(), 0);
  share_in_lanes(
      subtrees_.groups().size(), [&](int group) __attribute__((always_inline)) {
        bool flipped = false;
        clear(subtrees_.groups()[group]);
        fill(group);
        for (const int s : subtrees_.groups()[group]) {
          factorise_columns(node[s], lower + node[s].offset, upper + node[s].offset, flipped);
          const int inside = subtrees_.rows_inside(s);
          for (int p = 0; p < inside; ++p) pass_on(plan_, node[s], p, lower, upper);
        }
        flipped_[group] = flipped ? 1 : 0;
      });
  negative_ = std::ranges::count(flipped_, 1) % 2 == 1;
  clear(subtrees_.top());
  fill(subtrees_.part_of_top());
  // A column of the top has one writer.
  const std::size_t writers = subtrees_.border().empty() ? 0 : static_cast<std::size_t>(threads);
  share_in_lanes(
      writers, [&](int writer) __attribute__((always_inline)) {
        for (const int s : subtrees_.border()) {
          const int* row = plan_.rows(node[s]);
          for (int p = subtrees_.rows_inside(s); p < node[s].rows; ++p)
            if (row[p] % threads == writer) pass_on(plan_, node[s], p, lower, upper);
        }
      });
  with_lanes([&]() __attribute__((always_inline)) {
    for (const int s : subtrees_.top()) {
      const int rows = node[s].rows;
      factorise_columns(node[s], lower + node[s].offset, upper + node[s].offset, negative_);
      if (threads == 1 || static_cast<double>(node[s].columns) * rows * rows < kWorthSharing) {
        for (int p = 0; p < rows; ++p) pass_on(plan_, node[s], p, lower, upper);
        continue;
      }
      share_in_lanes(
          static_cast<std::size_t>(threads), [&](int writer) __attribute__((always_inline)) {
            for (int p = writer; p < rows; p += threads) pass_on(plan_, node[s], p, lower, upper);
          });
    }
  });
}

void BlockLu::solve(Eigen::Vector4d* x) const {
  const std::vector<Supernode>& node = plan_.supernodes();
  const PaddedBlock *lower = lower_.data(), *upper = upper_.data();
  const auto& groups = subtrees_.groups();
  const auto& top = subtrees_.top();
  share_in_lanes(
      groups.size(), [&](int group) __attribute__((always_inline)) {
        for (const int s : groups[group])
          solve_lower(plan_, node[s], 1, node[s].columns + subtrees_.rows_inside(s), lower, x);
      });
  with_lanes([&]() __attribute__((always_inline)) {
    for (const int s : subtrees_.border())
      solve_lower(plan_, node[s], node[s].columns + subtrees_.rows_inside(s),
                  node[s].columns + node[s].rows, lower, x);
    for (const int s : top)
      solve_lower(plan_, node[s], 1, node[s].columns + node[s].rows, lower, x);
    for (auto s = top.rbegin(); s != top.rend(); ++s) solve_upper(plan_, node[*s], lower, upper, x);
  });
  share_in_lanes(
      groups.size(), [&](int group) __attribute__((always_inline)) {
        for (auto s = groups[group].rbegin(); s != groups[group].rend(); ++s)
          solve_upper(plan_, node[*s], lower, upper, x);
      });
}

}  // namespace quicksand
