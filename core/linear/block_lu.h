// Sparse LU factorisation of matrices of 3x3 blocks on a graph: one block row a body, one edge a pair
// of bodies in contact. The pattern is symmetric, the values need not be.
//
// The network of a loose packing is nearly a tree, so there is almost no fill; no pivoting between
// blocks, which suits M + H^T D H (see contact_matrix.h). Right-looking by supernodes, with the place of
// every product known beforehand (see elimination.h); this is kept while the graph stays the same. Disjoint
// subtrees first, at the same time, each filled and eliminated by one thread, in whose cache it stays; then what
// they leave to the top, column by column, then the top.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "core/base/types.h"
#include "core/linear/elimination.h"
#include "core/linear/subtrees.h"

namespace quicksand {

using Mat3 = Eigen::Matrix3d;

// A 3x3 block over a row of zeros: four lanes a column.
struct alignas(32) PaddedBlock {
  using Entry = Eigen::Map<Mat3, 0, Eigen::OuterStride<4>>;
  Entry entry() { return Entry(&column[0][0]); }

  double column[3][4] = {};
};

class BlockLu {
 public:
  // Orders n block rows coupled by `edges`; repeated edges are allowed. Does nothing if the graph is
  // the same as before. Throws NotEnoughMemory if there is none for the factors.
  void analyse(int n, const std::vector<Edge>& edges);

  // The matrix: block (i, i), and for edge e the blocks (i, j) and (j, i), which add up where edges repeat.
  PaddedBlock& diagonal(int i) { return block(lower_, plan_.diagonal_slot(i)); }
  PaddedBlock& upper(int e) {
    return block(plan_.edge_flipped(e) ? lower_ : upper_, plan_.edge_slot(e));
  }
  PaddedBlock& lower(int e) {
    return block(plan_.edge_flipped(e) ? upper_ : lower_, plan_.edge_slot(e));
  }
  // Place of a block row in the order of elimination.
  int position(int i) const { return plan_.position(i); }

  // The columns are eliminated in so many parts. Block (i, i) lies in that of its row in the order of elimination, the
  // two of an edge in that of the first of their rows.
  int parts() const { return subtrees_.parts(); }
  int part_of(int position) const { return subtrees_.part_of(plan_.supernode_of(position)); }
  // Factorises the matrix whose blocks fill(part) writes into zeros, perhaps for several parts at the same time.
  void factorise(const std::function<void(int)>& fill);
  // x (n) := A^-1 x, in the order of elimination; the fourth numbers mean nothing.
  void solve(Eigen::Vector4d* x) const;

  // Whether the determinant of the factorised matrix is negative.
  bool negative() const { return negative_; }

  // Blocks in L, without the diagonal.
  std::size_t fill() const { return plan_.fill(); }
  // Multiplications and additions of factorise(), those of its 3x3 inverses included.
  double operations() const;

 private:
  void clear(const std::vector<int>& supernodes);  // ascending
  static PaddedBlock& block(std::vector<PaddedBlock>& blocks, int slot) {
    return blocks[static_cast<std::size_t>(slot)];
  }

  Elimination plan_;
  Subtrees subtrees_;
  bool ready_ = false;  // what follows is that of the plan
  bool negative_ = false;
  std::vector<char> flipped_;  // (groups) whether the determinant of theirs is negative
  // By slots. L has a unit diagonal; its place holds the inverted pivots. U has the block of row j and
  // column i where L has that of row i and column j.
  std::vector<PaddedBlock> lower_, upper_;
};

}  // namespace quicksand
