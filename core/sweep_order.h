// The order of the contacts in a sweep of Gauss-Seidel.
#pragma once

#include <cstdint>

namespace quicksand {

// At random, drawn anew for each sweep; that of the pairs; that and its reverse in turns.
enum class SweepOrder : std::uint8_t { random, sorted, alternating };

}  // namespace quicksand
