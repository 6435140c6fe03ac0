// The symbolic part of a sparse factorisation: order, fill, supernodes, and where each product goes.
//
// A minimum-degree ordering [Amestoy 1996], in postorder. Columns that follow each other and have the
// same rows below make a supernode, held as one trapezoid: block (i, j), rows counted from its first
// column on, is in slot offset + i * columns + j. Slots above the diagonal of a supernode stay empty.
#pragma once

#include <cstddef>
#include <vector>

namespace quicksand {

struct Edge {
  int i = 0;
  int j = 0;  // i != j
  bool operator==(const Edge&) const = default;
};

struct Supernode {
  int first = 0;    // column
  int columns = 0;  // from there on
  int rows = 0;     // below them
  int row = 0;      // place of the first of these in Elimination::rows()
  int offset = 0;   // its first slot
  int target = 0;   // the first of its products in Elimination::targets()
};

class Elimination {
 public:
  // Of n block rows coupled by `edges`, which may repeat. False if the graph is the same as before: then
  // nothing is done. Throws NotEnoughMemory if there is none, with so many bytes a slot.
  bool analyse(int n, const std::vector<Edge>& edges, std::size_t bytes_of_slot);

  int size() const { return n_; }
  int slots() const { return slots_; }
  const std::vector<Supernode>& supernodes() const { return supernode_; }
  const int* rows(const Supernode& s) const { return row_.data() + s.row; }  // ascending
  int supernode_of(int row) const { return supernode_of_[static_cast<std::size_t>(row)]; }
  // For each supernode, each p of its rows, and each q from p on: the slot of row q in column p.
  const std::vector<int>& targets() const { return target_; }

  // Where body i and edge e are: a row, the slot of block (i, i), that of the blocks (i, j) and (j, i),
  // and whether j comes before i.
  int position(int i) const { return position_[i]; }
  int diagonal_slot(int i) const { return diagonal_slot_[i]; }
  int edge_slot(int e) const { return edge_slot_[e]; }
  bool edge_flipped(int e) const { return edge_flipped_[e] != 0; }

  std::size_t fill() const { return column_row_.size(); }  // blocks below the diagonal

 private:
  void plan(int n, const std::vector<Edge>& edges, std::size_t bytes_of_slot);
  void order();
  void find_columns();
  void find_supernodes();
  void make_room(std::size_t bytes_of_slot);
  void find_targets();
  int slot(int row, int column) const;

  int n_ = -1;
  int slots_ = 0;
  std::vector<Edge> edges_;
  std::vector<int> position_;      // (n)
  std::vector<int> column_start_;  // (n + 1) in column_row_
  std::vector<int> column_row_;    // rows below the diagonal, ascending in a column
  std::vector<Supernode> supernode_;
  std::vector<int> supernode_of_;   // (n) column
  std::vector<int> row_;            // by supernodes
  std::vector<int> target_;         // slots
  std::vector<int> diagonal_slot_;  // (n)
  std::vector<int> edge_slot_;      // (edges)
  std::vector<char> edge_flipped_;  // (edges)
};

}  // namespace quicksand
