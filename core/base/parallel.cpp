#include "core/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace quicksand {

namespace {

// Of the work that this thread has begun; none: as many as its arena has.
thread_local const std::atomic<int>* granted_now = nullptr;

struct Granted {
  const std::atomic<int>* before;
  explicit Granted(const std::atomic<int>* now) : before(granted_now) { granted_now = now; }
  ~Granted() { granted_now = before; }
  Granted(const Granted&) = delete;
  Granted& operator=(const Granted&) = delete;
};

void in_arena(int threads, const std::atomic<int>* now, const std::function<void()>& work) {
  const Granted granted(now);
  // More than there are cores are a way to test what depends on their number.
  const auto most = static_cast<std::size_t>(std::max(threads, tbb::info::default_concurrency()));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, most);
  tbb::task_arena(threads).execute(work);
}

}  // namespace

int usable_threads() {
  const int most = tbb::this_task_arena::max_concurrency();
  return granted_now ? std::clamp(granted_now->load(), 1, most) : most;
}

void with_threads(int threads, const std::function<void()>& work) {
  in_arena(threads, nullptr, work);
}

void with_threads(int most, const std::atomic<int>& now, const std::function<void()>& work) {
  in_arena(most, &now, work);
}

void parallel::in_parts(int threads, const std::function<void(int)>& work) {
  tbb::parallel_for(
      0, threads,
      [&](int) { work(std::max(0, tbb::this_task_arena::current_thread_index()) % threads); },
      tbb::simple_partitioner());
}

}  // namespace quicksand
