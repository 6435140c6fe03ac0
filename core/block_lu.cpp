#include "core/block_lu.h"

#include <algorithm>
#include <cmath>

#include "core/lanes.h"

namespace quicksand {

namespace {

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

// Inverts by elimination with row pivoting. A pivot block holds stiffnesses from 1 to 1e7: cofactors
// would lose the soft directions. Flips `negative` if the determinant is below zero.
[[gnu::always_inline]] inline void invert(PaddedBlock& block, bool& negative) {
  BlockLu::Entry entry(&block.column[0][0]);
  Mat3 a = entry, b = Mat3::Identity();
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
  entry = b;
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

[[gnu::always_inline]] inline bool factorise_all(const Elimination& plan, PaddedBlock* all_lower,
                                                 PaddedBlock* all_upper) {
  bool negative = false;
  const int* target = plan.targets().data();
  for (const Supernode& node : plan.supernodes()) {
    const int s = node.columns, m = s + node.rows;
    PaddedBlock* lower = all_lower + node.offset;
    PaddedBlock* upper = all_upper + node.offset;
    factorise_columns(node, lower, upper, negative);
    for (int p = s; p < m; ++p) {
      subtract_products(lower + p * s, upper + p * s, s, all_lower[*target++]);
      for (int q = p + 1; q < m; ++q) {
        const int t = *target++;
        subtract_products(lower + q * s, upper + p * s, s, all_lower[t]);
        subtract_products(lower + p * s, upper + q * s, s, all_upper[t]);
      }
    }
  }
  return negative;
}

[[gnu::always_inline]] inline void solve_lower(const Elimination& plan,
                                               const PaddedBlock* all_lower, Eigen::Vector4d* x) {
  for (const Supernode& node : plan.supernodes()) {
    const int s = node.columns, m = s + node.rows;
    const PaddedBlock* lower = all_lower + node.offset;
    const int* row = plan.rows(node);
    for (int i = 1; i < m; ++i) {
      double* to = x[i < s ? node.first + i : row[i - s]].data();
      Lanes y;
      load_lanes(to, y);
      for (int j = 0; j < std::min(i, s); ++j)
        subtract_product(lower[i * s + j], x[node.first + j].data(), y);
      store_lanes(y, to);
    }
  }
}

[[gnu::always_inline]] inline void solve_upper(const Elimination& plan,
                                               const PaddedBlock* all_lower,
                                               const PaddedBlock* all_upper, Eigen::Vector4d* x) {
  for (auto node = plan.supernodes().rbegin(); node != plan.supernodes().rend(); ++node) {
    const int s = node->columns, m = s + node->rows;
    const PaddedBlock* lower = all_lower + node->offset;
    const PaddedBlock* upper = all_upper + node->offset;
    const int* row = plan.rows(*node);
    for (int j = s - 1; j >= 0; --j) {
      double* to = x[node->first + j].data();
      Lanes y;
      load_lanes(to, y);
      for (int i = j + 1; i < m; ++i)
        subtract_product(upper[i * s + j], x[i < s ? node->first + i : row[i - s]].data(), y);
      store_lanes(y, to);
      LoadedBlock inverse;
      load_block(lower[j * s + j], inverse);
      multiply(inverse, to, y);
      store_lanes(y, to);
    }
  }
}

}  // namespace

void BlockLu::analyse(int n, const std::vector<Edge>& edges) {
  plan_.analyse(n, edges, 2 * sizeof(PaddedBlock));
  lower_.resize(static_cast<std::size_t>(plan_.slots()));
  upper_.resize(lower_.size());
  work_.resize(static_cast<std::size_t>(n));
}

void BlockLu::clear() {
  std::ranges::fill(lower_, PaddedBlock{});
  std::ranges::fill(upper_, PaddedBlock{});
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

void BlockLu::factorise() {
  with_lanes([&]() __attribute__((always_inline)) {
    negative_ = factorise_all(plan_, lower_.data(), upper_.data());
  });
}

void BlockLu::solve(std::vector<Vec3>& x) {
  for (int i = 0; i < plan_.size(); ++i) work_[plan_.position(i)] << x[i], 0;
  with_lanes([&]() __attribute__((always_inline)) {
    solve_lower(plan_, lower_.data(), work_.data());
    solve_upper(plan_, lower_.data(), upper_.data(), work_.data());
  });
  for (int i = 0; i < plan_.size(); ++i) x[i] = work_[plan_.position(i)].head<3>();
}

}  // namespace quicksand
