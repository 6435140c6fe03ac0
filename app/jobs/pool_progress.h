// What a user sees while many runs are computed: done, failed, how long the rest will take, and where the
// one that began first is.
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "app/base/status_line.h"

namespace quicksand {

// A run that is being computed.
struct RunUnderWay {
  std::string_view id;
  std::string_view phase;  // empty: it has not begun
  double phase_done = 0;   // share of that phase
  double now_done = 0;     // share of the whole run, since it was taken up now
  double left = 1;         // share of the whole run
};

class PoolProgress {
 public:
  PoolProgress(std::size_t jobs, bool quiet)
      : jobs_(jobs), line_(StatusLine::style_of_stderr(quiet)) {}

  // After a job has ended; `computed` if it was not found finished.
  void count(bool computed, bool failed);
  // Whether there is something to show now.
  bool due() const { return line_.due(); }
  // `running`: the one that began first comes first.
  void show(std::span<const RunUnderWay> running);
  void end() { line_.end(); }

  // What is shown when so much time has been spent. [s]
  std::string text(std::span<const RunUnderWay> running, double spent) const;

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
