#include "core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace quicksand {

int usable_threads() { return tbb::this_task_arena::max_concurrency(); }

namespace parallel {

void in_arena(int threads, Call call, const void* work) {
  // More than there are cores are a way to test what depends on their number.
  const auto most = static_cast<std::size_t>(std::max(threads, tbb::info::default_concurrency()));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, most);
  tbb::task_arena(threads).execute([&] { call(work, 0); });
}

void in_parts(int parts, Call call, const void* work) {
  tbb::parallel_for(
      0, parts, [&](int part) { call(work, part); }, tbb::simple_partitioner());
}

}  // namespace parallel

}  // namespace quicksand
