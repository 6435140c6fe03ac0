// The smallest force that moves something, between two forces: one that did not and one that did.
//
// The first force is doubled until it moves or halved until it does not; then the middle is tried until
// (high - low)/high <= tolerance. Where the first three forces all move it, the fourth trial has none: what
// moves by its weight alone is found so, and not by halving to the end. One change from holding to moving
// is assumed; if there are several, the interval holds one of them.
#pragma once

#include <optional>

namespace quicksand {

struct ForceBracket {
  // The first force is not doubled or halved more often than this.
  static constexpr int kMostDoublings = 20;
  // A tolerance that the numbers cannot resolve ends here.
  static constexpr int kMostTrials = 100;
  // Trials that all moved it, after which one has no force.
  static constexpr int kBeforeNone = 3;

  double first = 1;                 // force of the first trial, above 0 [F_g]
  double low = 0;                   // greatest force that did not move it; 0: none was found [F_g]
  std::optional<double> high = {};  // smallest that did; 0: it needs none; empty: none did [F_g]
  double held =
      0;  // greatest force whose trial came to rest, others only ran out of time; 0: none [F_g]
  int trials = 0;  // outcomes recorded

  // Force of the next trial [F_g].
  double next() const;
  // Outcome of the trial with that force; what did not move is `decided` if it came to rest.
  void record(bool moved, bool decided = true);
  // Whether the interval is narrow enough [1], or the limits of the search are reached: then high is 0 (it
  // moved without a force), low is 0 (it moved at any down to first/2^20) or high is empty (nothing moved it
  // up to first 2^20).
  bool done(double tolerance) const;
};

}  // namespace quicksand
