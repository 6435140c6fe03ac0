// What a user sees while a run computes: on a terminal one line that is written over, elsewhere a line
// at the beginning of each phase and every ten seconds.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "app/base/status_line.h"
#include "core/protocol/protocol.h"

namespace quicksand {

class ProgressLine {
 public:
  using Style = StatusLine::Style;

  explicit ProgressLine(Style style) : line_(style) {}

  // After each call of Protocol::advance(); shows something only when it is time to.
  void show(const Protocol& protocol);
  // Leaves the line that was written over.
  void end() { line_.end(); }

 private:
  using Clock = std::chrono::steady_clock;

  void begin_phase(const Protocol& protocol);
  static std::string heading(const Protocol& protocol);
  std::string line(const Protocol& protocol, double seconds_since_shown);

  StatusLine line_;
  Clock::time_point shown_ = Clock::now();
  Clock::time_point phase_began_;
  std::int64_t shown_step_ = 0;
  int phase_ = -1;
  double phase_began_at_ = 0;  // share of the phase that was done then
};

}  // namespace quicksand
