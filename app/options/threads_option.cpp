#include "app/options/threads_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "app/options/number_range.h"

namespace quicksand {

namespace {

constexpr std::int64_t kMostThreads = 1024;  // more is taken for a mistake

}  // namespace

void add_threads_option(CLI::App& command, std::int64_t& threads, const char* meaning) {
  command.add_option("--threads", threads, std::string(meaning) + " [number of cores]")
      ->type_name("N")
      ->check(whole_in_range(1, kMostThreads));
}

int thread_count(std::int64_t asked) {
  if (asked > 0) return static_cast<int>(asked);
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace quicksand
