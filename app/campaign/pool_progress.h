// What a user sees while many runs are computed: done, failed, and how long the rest will take.
#pragma once

#include <chrono>
#include <cstddef>

#include "app/status_line.h"

namespace quicksand {

class PoolProgress {
 public:
  PoolProgress(std::size_t jobs, bool quiet)
      : jobs_(jobs), line_(StatusLine::style_of_stderr(quiet)) {}

  // After a job has ended; `computed` if it was not found finished.
  void count(bool computed, bool failed);
  // Shows something only when it is time to.
  void show(std::size_t running);
  void end() { line_.end(); }

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t jobs_;
  std::size_t ended_ = 0;
  std::size_t computed_ = 0;
  std::size_t failed_ = 0;
  Clock::time_point began_ = Clock::now();
  StatusLine line_;
};

}  // namespace quicksand
