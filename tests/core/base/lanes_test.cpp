// Wide registers and narrow ones compute the same bytes.
#include "core/base/lanes.h"

#include <gtest/gtest.h>

#include <array>

namespace quicksand {
namespace {

using Four = std::array<double, 4>;

// A long sum of products, whose rounding depends on the order of its operations.
[[gnu::always_inline]] inline void sum_products(const Four& a, const Four& b, Four& sum) {
  Lanes x, y, total;
  load_lanes(a.data(), x);
  load_lanes(b.data(), y);
  load_lanes(sum.data(), total);
  for (int k = 0; k < 1000; ++k) {
    total -= x * y + x * 0.1;
    x = x * 0.9 + y / 30;
    y = y * 0.9 - x / 7;
  }
  store_lanes(total, sum.data());
}

TEST(Lanes, WideRegistersGiveTheSameBytes) {
  const Four a{0.1, -0.7, 1e-3, 12}, b{0.3, 2, -1e3, 1e-7};
  Four narrow{1, 2, 3, 4}, wide = narrow, chosen = narrow;
  sum_products(a, b, narrow);
  with_lanes([&]() __attribute__((always_inline)) { sum_products(a, b, chosen); });
  EXPECT_EQ(narrow, chosen);
  // Where the processor has wide registers, these are what was chosen; not by chance, then.
  if (has_wide_registers()) {
    in_wide_registers([&]() __attribute__((always_inline)) { sum_products(a, b, wide); });
    EXPECT_EQ(narrow, wide);
  }
  EXPECT_NE(narrow, (Four{1, 2, 3, 4}));
}

}  // namespace
}  // namespace quicksand
