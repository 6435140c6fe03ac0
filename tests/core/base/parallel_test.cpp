#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace quicksand {
namespace {

TEST(Threads, AreThoseThatTheCallerGrants) {
  for (const int threads : {1, 2, 3})
    with_threads(threads, [&] { EXPECT_EQ(usable_threads(), threads); });
  with_threads(3, [] { with_threads(1, [] { EXPECT_EQ(usable_threads(), 1); }); });
}

TEST(Threads, MayBecomeMoreAndFewerMeanwhile) {
  std::atomic<int> now = 1;
  with_threads(3, now, [&] {
    EXPECT_EQ(usable_threads(), 1);
    now = 2;
    EXPECT_EQ(usable_threads(), 2);
    now = 5;
    EXPECT_EQ(usable_threads(), 3) << "no more than there are";
    with_threads(2, [&] { EXPECT_EQ(usable_threads(), 2) << "granted to another"; });
    now = 1;
    EXPECT_EQ(usable_threads(), 1);
  });
  with_threads(3, [] { EXPECT_EQ(usable_threads(), 3); });
}

TEST(SharedParts, AreNeverInMoreHandsThanNowGranted) {
  const std::atomic<int> now = 2;
  std::atomic<int> busy = 0, most = 0;
  with_threads(5, now, [&] {
    share_parts(200, [&](int) {
      const int here = ++busy;
      int before = most;
      while (before < here && !most.compare_exchange_weak(before, here)) {
      }
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      --busy;
    });
  });
  EXPECT_GE(most, 1);
  EXPECT_LE(most, 2);
}

// So that what a part writes stays in one cache. A thread that comes late finds some of its parts taken: once in many
// tries it must not.
TEST(SharedParts, BeginWithTheSameOnesOnEachThread) {
  const std::vector<int> first_half{0, 1, 2, 3};
  bool met = false;
  with_threads(2, [&] {
    for (int again = 0; again < 20 && !met; ++again) {
      std::vector<int> here;
      share_parts(8, [&, caller = std::this_thread::get_id()](int part) {
        if (std::this_thread::get_id() == caller) here.push_back(part);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      });
      met = here == first_half;
    }
  });
  EXPECT_TRUE(met);
}

TEST(SharedRange, VisitsEveryIndexOnce) {
  for (const std::size_t n : {0, 1, 2999, 3000, 12345})
    for (const int threads : {1, 2, 5}) {
      std::vector<std::atomic<int>> visits(n);
      with_threads(threads, [&] {
        share_range(n, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
      });
      for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(visits[i], 1) << i << " of " << n;
    }
}

struct Sum {
  double value = 0;
  void add(const Sum& other) { value += other.value; }
};

// Of rounded numbers, whose sum depends on the order.
TEST(GatheredRange, HasTheSameBytesForAnyNumberOfThreads) {
  const auto sum = [](int threads, std::size_t n) {
    Sum found;
    with_threads(threads, [&] {
      found = gather_range<Sum>(n, [](std::size_t begin, std::size_t end, Sum& part) {
        for (std::size_t i = begin; i < end; ++i) part.value += 1 / (1.0 + static_cast<double>(i));
      });
    });
    return found.value;
  };
  for (const std::size_t n : {0, 1000, 1025, 3000, 54321}) {
    EXPECT_EQ(sum(1, n), sum(2, n));
    EXPECT_EQ(sum(1, n), sum(7, n));
  }
  EXPECT_NEAR(sum(2, 54321), 11.480, 1e-3);
}

TEST(SharedParts, HandOnWhatIsThrown) {
  with_threads(2, [] {
    EXPECT_THROW(share_parts(8,
                             [](int part) {
                               if (part == 5) throw std::runtime_error("part 5");
                             }),
                 std::runtime_error);
  });
}

}  // namespace
}  // namespace quicksand
