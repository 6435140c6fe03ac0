#include "app/web/exchange.h"

#include <gtest/gtest.h>

namespace quicksand::test {
namespace {

using namespace std::chrono_literals;

TEST(Exchange, AClientThatFloodsKeepsNoOtherOut) {
  Exchange exchange;
  std::ptrdiff_t given = 0;
  while (given < 10'000 && exchange.give({1, "many"})) ++given;
  EXPECT_EQ(given, Exchange::kMostOfOneClient);
  EXPECT_TRUE(exchange.give({2, "one"}));
  EXPECT_EQ(exchange.take(0ms, false).size(), static_cast<std::size_t>(given) + 1);
  EXPECT_TRUE(exchange.give({1, "again"}));
}

}  // namespace
}  // namespace quicksand::test
