#include "core/protocol/force_bracket.h"

#include <cmath>

namespace quicksand {

double ForceBracket::next() const {
  if (trials == 0) return first;
  if (!high) return 2 * low;
  if (low == 0 && trials == kBeforeNone) return 0;
  return low == 0 ? *high / 2 : low + (*high - low) / 2;
}

void ForceBracket::record(bool moved, bool decided) {
  const double force = next();
  ++trials;
  if (moved) {
    high = force;
  } else {
    low = force;
    if (decided) held = force;
  }
}

bool ForceBracket::done(double tolerance) const {
  if (trials == 0) return false;
  if (trials >= kMostTrials) return true;
  if (!high) return low >= std::ldexp(first, kMostDoublings);
  if (low == 0) return *high <= std::ldexp(first, -kMostDoublings);
  return *high - low <= tolerance * *high;
}

}  // namespace quicksand
