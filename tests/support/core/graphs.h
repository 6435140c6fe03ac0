// Graphs of bodies that touch.
#pragma once

#include <vector>

#include "core/linear/elimination.h"

namespace quicksand {

// side x side bodies.
inline std::vector<Edge> square_lattice(int side) {
  std::vector<Edge> edges;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (x + 1 < side) edges.push_back({y * side + x, y * side + x + 1});
      if (y + 1 < side) edges.push_back({y * side + x, (y + 1) * side + x});
    }
  return edges;
}

inline std::vector<Edge> chain(int n) {
  std::vector<Edge> edges;
  for (int i = 0; i + 1 < n; ++i) edges.push_back({i, i + 1});
  return edges;
}

}  // namespace quicksand
