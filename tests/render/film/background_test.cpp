#include "render/film/background.h"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace quicksand {
namespace {

TEST(Background, HandlesItemsInTheirOrder) {
  std::vector<int> handled;
  Background<int> background(2, [&] { return [&](int item) { handled.push_back(item); }; });
  for (int k = 0; k < 100; ++k) background.add(k);
  background.finish();
  ASSERT_EQ(handled.size(), 100U);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(handled[static_cast<std::size_t>(k)], k);
}

// Who adds goes on while an item is handled: waiting for the gate would last for ever.
TEST(Background, WorksBesideTheOneWhoAdds) {
  std::promise<void> gate;
  int handled = 0;
  Background<int> background(2, [&] {
    return [&, opened = gate.get_future().share()](int) {
      opened.wait();
      ++handled;
    };
  });
  background.add(1);
  background.add(2);
  gate.set_value();
  background.finish();
  EXPECT_EQ(handled, 2);
}

// A drawing context belongs to one thread, from its making to its end.
TEST(Background, PreparesHandlesAndCleansUpOnOneThread) {
  std::vector<std::thread::id> threads;
  const auto note = [&] { threads.push_back(std::this_thread::get_id()); };
  {
    Background<int> background(2, [&] {
      note();
      const std::shared_ptr<void> context(nullptr, [&](void*) { note(); });
      return [&, context](int) { note(); };
    });
    background.add(1);
    background.finish();
  }
  ASSERT_EQ(threads.size(), 3U);
  for (const auto& thread : threads) {
    EXPECT_EQ(thread, threads.front());
    EXPECT_NE(thread, std::this_thread::get_id());
  }
}

TEST(Background, WhatCannotBePreparedIsNotConstructed) {
  const auto prepare = []() -> Background<int>::Handle { throw std::runtime_error("no context"); };
  EXPECT_THROW(Background<int>(2, prepare), std::runtime_error);
}

TEST(Background, AFailureIsToldAndLaterItemsAreDropped) {
  std::vector<int> handled;
  Background<int> background(8, [&] {
    return [&](int item) {
      if (item == 1) throw std::runtime_error("the disk is full");
      handled.push_back(item);
    };
  });
  background.add(0);
  background.add(1);
  EXPECT_THROW(background.finish(), std::runtime_error);
  EXPECT_THROW(background.add(2), std::runtime_error);
  EXPECT_EQ(handled, std::vector{0});
}

TEST(Background, HandlesWhatWaitsBeforeItEnds) {
  int handled = 0;
  {
    Background<int> background(8, [&] { return [&](int) { ++handled; }; });
    for (int k = 0; k < 5; ++k) background.add(k);
  }
  EXPECT_EQ(handled, 5);
}

}  // namespace
}  // namespace quicksand
