// A counter-based random stream: the same numbers from the same seed on every system, and a state
// of one integer, so that a checkpoint holds it whole. SplitMix64, [Steele 2014].
#pragma once

#include <cstdint>

namespace quicksand {

struct Random {
  std::uint64_t state = 0;

  std::uint64_t next() {
    std::uint64_t z = (state += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }

  // Uniform in [0, 1), with 53 random bits.
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
};

}  // namespace quicksand
