// Loops that share their work between the cores, where a system is large enough to gain.
//
// What a loop computes does not depend on the number of threads: each index writes its own place, and what is
// gathered over indices is gathered in blocks that depend on the number of indices only. A thread that is
// busy elsewhere is not waited for: what it did not begin the others do (oneTBB's scheduler).
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace quicksand {

// Threads that a loop may use here: all cores, but inside with_threads().
int usable_threads();

// Calls work() such that its loops use at most so many threads, the caller's included; from 1.
void with_threads(int threads, const std::function<void()>& work);
// The same at most with so many as `now` says, which may change meanwhile.
void with_threads(int most, const std::atomic<int>& now, const std::function<void()>& work);

namespace parallel {
// Fewer contacts than these are not worth the waking of a thread.
inline constexpr std::size_t kWorthSharing = 3000;
inline constexpr int kMostThreads = 64;  // that share one loop
// On a cache line of its own.
struct alignas(64) Counter {
  std::atomic<int> next = 0;
};
// work(thread) on so many threads, by their own numbers from 0; perhaps several times on one.
void in_parts(int threads, const std::function<void(int)>& work);
}  // namespace parallel

// work(0), ..., work(parts - 1), in any order and perhaps at the same time. A thread begins with the same parts each
// time, whose data are then in its own cache, and goes on with what others have not begun.
template <class Work>
void share_parts(int parts, const Work& work) {
  const int threads = std::min({parts, usable_threads(), parallel::kMostThreads});
  if (threads <= 1) {
    for (int part = 0; part < parts; ++part) work(part);
    return;
  }
  const auto first = [&](int thread) { return parts * thread / threads; };
  std::array<parallel::Counter, parallel::kMostThreads> begun;
  for (int k = 0; k < threads; ++k) begun[k].next = first(k);
  parallel::in_parts(threads, [&](int thread) {
    for (int k = 0; k < threads; ++k) {
      const int of = (thread + k) % threads, end = first(of + 1);
      for (int part = begun[of].next++; part < end; part = begun[of].next++) work(part);
    }
  });
}

// work(begin, end) for ranges that make up 0 to n; shared from `worth` on.
template <class Work>
void share_range(std::size_t n, const Work& work, std::size_t worth = parallel::kWorthSharing) {
  if (n < worth) return work(std::size_t{0}, n);
  const auto parts = static_cast<std::size_t>(usable_threads());
  share_parts(static_cast<int>(parts), [&](int part) {
    const auto k = static_cast<std::size_t>(part);
    work(n * k / parts, n * (k + 1) / parts);
  });
}

// Gathers collect(begin, end, x) over blocks of 0 to n, each from a T{}, into one by sum.add(x), in order.
template <class T, class Collect>
T gather_range(std::size_t n, const Collect& collect, std::size_t worth = parallel::kWorthSharing) {
  const std::size_t size = worth / 3, blocks = (n + size - 1) / size;
  const auto collect_block = [&](std::size_t block, T& x) {
    collect(block * size, std::min(n, (block + 1) * size), x);
  };
  T sum{};
  if (n < worth) {
    for (std::size_t block = 0; block < blocks; ++block) {
      T x{};
      collect_block(block, x);
      sum.add(x);
    }
    return sum;
  }
  std::vector<T> of_block(blocks);
  share_parts(static_cast<int>(blocks), [&](int part) {
    collect_block(static_cast<std::size_t>(part), of_block[static_cast<std::size_t>(part)]);
  });
  for (const T& x : of_block) sum.add(x);
  return sum;
}

}  // namespace quicksand
