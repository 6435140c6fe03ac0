// Loops that share their work between the cores, where a system is large enough to gain.
//
// What a loop computes does not depend on the number of threads: each index writes its own place, and what is
// gathered over indices is gathered in blocks that depend on the number of indices only. A thread that is
// busy elsewhere is not waited for: what it did not begin the others do (oneTBB's scheduler).
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

namespace quicksand {

// Threads that a loop may use here: all cores, but inside with_threads().
int usable_threads();

// Calls work() such that its loops use at most so many threads, the caller's included; from 1.
template <class Work>
void with_threads(int threads, const Work& work);
// The same at most with so many as `now` says, which may change meanwhile.
template <class Work>
void with_threads(int most, const std::atomic<int>& now, const Work& work);

// work(0), ..., work(parts - 1), in any order and perhaps at the same time.
template <class Work>
void share_parts(int parts, const Work& work);

namespace parallel {
// Fewer contacts than these are not worth the waking of a thread.
inline constexpr std::size_t kWorthSharing = 3000;
}  // namespace parallel

// work(begin, end) for ranges that make up 0 to n; shared from `worth` on.
template <class Work>
void share_range(std::size_t n, const Work& work, std::size_t worth = parallel::kWorthSharing);

// Gathers collect(begin, end, x) over blocks of 0 to n, each from a T{}, into one by sum.add(x), in order.
template <class T, class Collect>
T gather_range(std::size_t n, const Collect& collect, std::size_t worth = parallel::kWorthSharing);

// at_a(c, row) and at_b(c, row) for each contact c of the problem, in order at each body: what they add to
// theirs is added as if one thread did it all.
template <class Problem, class AtA, class AtB>
void visit_sides(const Problem& problem, const AtA& at_a, const AtB& at_b);

namespace parallel {

using Call = void (*)(const void* work, int part);
void in_arena(int threads, const std::atomic<int>* now, Call call, const void* work);
void in_parts(int parts, Call call, const void* work);

template <class Work>
void call_with_part(const void* work, int part) {
  (*static_cast<const Work*>(work))(part);
}

}  // namespace parallel

template <class Work>
void with_threads(int threads, const Work& work) {
  const auto call = [&](int) { work(); };
  parallel::in_arena(threads, nullptr, parallel::call_with_part<decltype(call)>, &call);
}

template <class Work>
void with_threads(int most, const std::atomic<int>& now, const Work& work) {
  const auto call = [&](int) { work(); };
  parallel::in_arena(most, &now, parallel::call_with_part<decltype(call)>, &call);
}

template <class Work>
void share_parts(int parts, const Work& work) {
  std::atomic<int> next = 0;
  const auto take = [&](int) {
    for (int part = next++; part < parts; part = next++) work(part);
  };
  const int threads = std::min(parts, usable_threads());
  if (threads > 1)
    parallel::in_parts(threads, parallel::call_with_part<decltype(take)>, &take);
  else
    take(0);
}

template <class Work>
void share_range(std::size_t n, const Work& work, std::size_t worth) {
  if (n < worth) return work(std::size_t{0}, n);
  const auto parts = static_cast<std::size_t>(usable_threads());
  share_parts(static_cast<int>(parts), [&](int part) {
    const auto k = static_cast<std::size_t>(part);
    work(n * k / parts, n * (k + 1) / parts);
  });
}

template <class T, class Collect>
T gather_range(std::size_t n, const Collect& collect, std::size_t worth) {
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

template <class Problem, class AtA, class AtB>
void visit_sides(const Problem& problem, const AtA& at_a, const AtB& at_b) {
  share_range(problem.inverse_mass.size(), [&](std::size_t begin, std::size_t end) {
    const auto ours = [first = static_cast<int>(begin), last = static_cast<int>(end)](int body) {
      return first <= body && body < last;
    };
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
      const auto& row = problem.contacts[c];
      if (ours(row.a)) at_a(c, row);
      if (ours(row.b)) at_b(c, row);
    }
  });
}

}  // namespace quicksand
