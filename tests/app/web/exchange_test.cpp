#include "app/web/exchange.h"

#include <gtest/gtest.h>

#include "app/web/client.h"

namespace quicksand::test {
namespace {

using namespace std::chrono_literals;

TEST(Exchange, AClientThatFloodsKeepsNoOtherOut) {
  Exchange exchange;
  std::size_t given = 0;
  while (given < 10'000 && exchange.give({1, "many"})) ++given;
  EXPECT_EQ(given, kMostOfOneClient.messages);
  EXPECT_TRUE(exchange.give({2, "one"}));
  EXPECT_EQ(exchange.take(0ms, false).size(), given + 1);
  EXPECT_TRUE(exchange.give({1, "again"}));
}

TEST(Exchange, WhatWaitsIsBoundedInBytesToo) {
  Exchange exchange;
  const std::string large(60'000, ' ');
  std::size_t given = 0;
  while (given < 10'000 && exchange.give({1, large})) ++given;
  EXPECT_GT(given, 10U);
  EXPECT_LE(given * large.size(), kMostOfOneClient.bytes);
  // Of however many clients.
  for (ClientId client = 2; client < 1000; ++client)
    while (given < 100'000 && exchange.give({client, large})) ++given;
  EXPECT_LE(given * large.size(), kMostOfAll.bytes);
  for (ClientId client = 1000; client < 10'000; ++client)
    while (given < 100'000 && exchange.give({client, ""})) ++given;
  EXPECT_EQ(given, kMostOfAll.messages);
}

TEST(Exchange, WhoHasGoneHasNothingWaiting) {
  Exchange exchange;
  ASSERT_TRUE(exchange.give({1, "one"}));
  ASSERT_TRUE(exchange.give({2, "two"}));
  exchange.forget(1);
  const std::vector<ClientText> left = exchange.take(0ms, false);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].text, "two");
  EXPECT_TRUE(exchange.something_waits()) << "the computing thread is told";
  EXPECT_EQ(exchange.take_gone(), (std::vector<ClientId>{1}));
  EXPECT_FALSE(exchange.something_waits());
}

TEST(Client, IsStuckWithManyAnswersAndWithLargeOnes) {
  Client small(1, {}), large(2, {});
  int few = 0, many = 0;
  for (; !large.is_stuck() && few < 10'000; ++few) large.answer(std::string(60'000, ' '));
  for (; !small.is_stuck() && many < 10'000; ++many) small.answer("{}");
  EXPECT_LT(few, many);
  EXPECT_LT(many, 1000);
  Exchange exchange;
  while (large.is_stuck()) ASSERT_NE(large.next(exchange).bytes, nullptr);
  large.answer("{}");
  EXPECT_FALSE(large.is_stuck()) << "what was sent counts no more";
}

}  // namespace
}  // namespace quicksand::test
