// Sparse LU factorisation of matrices of 3x3 blocks on a graph: one block row a body, one edge a pair
// of bodies in contact. The pattern is symmetric, the values need not be.
//
// The network of a loose packing is nearly a tree, so a minimum-degree ordering [Amestoy 1996] leaves
// almost no fill; no pivoting between blocks, which suits M + H^T D H (see contact_matrix.h).
// Right-looking by columns, with the place of every product known beforehand; this is kept while the graph stays the same.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/types.h"

namespace quicksand {

using Mat3 = Eigen::Matrix3d;

struct Edge {
  int i = 0;
  int j = 0;  // i != j
  bool operator==(const Edge&) const = default;
};

class BlockLu {
 public:
  // Orders n block rows coupled by `edges`; repeated edges are allowed. Does nothing if the graph is
  // the same as before. Throws NotEnoughMemory if there is none for the factors.
  void analyse(int n, const std::vector<Edge>& edges);

  // The matrix, to be filled before factorise(): block (i, i), and for edge e the blocks (i, j) and
  // (j, i), which add up where edges repeat.
  void clear();
  Mat3& diagonal(int i) { return pivot_[static_cast<std::size_t>(position_[i])]; }
  Mat3& upper(int e) { return edge_flipped_[e] ? lower_[edge_slot_[e]] : upper_[edge_slot_[e]]; }
  Mat3& lower(int e) { return edge_flipped_[e] ? upper_[edge_slot_[e]] : lower_[edge_slot_[e]]; }

  // Replaces the matrix by its factors.
  void factorise();
  // x (n) := A^-1 x.
  void solve(std::vector<Vec3>& x);

  // Whether the determinant of the factorised matrix is negative.
  bool negative() const { return negative_; }

  // Blocks in L, without the diagonal.
  std::size_t fill() const { return row_.size(); }
  // Multiplications and additions of factorise(), those of its 3x3 inverses included.
  double operations() const;

 private:
  void order(const std::vector<Edge>& edges);
  void find_structure(const std::vector<Edge>& edges);
  void make_room();

  int n_ = -1;
  bool negative_ = false;
  std::vector<Edge> edges_;
  std::vector<int> position_;       // (n) place of a block row in the elimination order
  std::vector<int> start_;          // (n + 1) columns of L in row_, lower_, upper_
  std::vector<int> row_;            // rows below the diagonal, ascending in a column
  std::vector<int> target_;         // places of the products of factorise(), in its order
  std::vector<int> edge_slot_;      // (edges) place in lower_ and upper_
  std::vector<char> edge_flipped_;  // (edges) whether j comes before i in the order
  std::vector<Mat3> pivot_;         // (n) diagonal blocks, inverted by factorise()
  std::vector<Mat3> lower_;         // L by columns (unit diagonal)
  std::vector<Mat3> upper_;         // U by rows, same places as the transposed entry of L
  std::vector<Vec3> work_;          // (n)
};

}  // namespace quicksand
