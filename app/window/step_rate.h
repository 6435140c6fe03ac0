// How fast it goes, over the last second: steps, and the share of the present phase.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "core/protocol/protocol.h"

namespace quicksand {

class StepRate {
 public:
  void add(std::int64_t steps, const Protocol& protocol) {
    steps_ += steps;
    const double seconds = std::chrono::duration<double>(Clock::now() - since_).count();
    if (seconds < 1) return;
    const double done = protocol.phase() != nullptr ? protocol.phase_progress() : 1;
    const double progress = protocol.state().phase == phase_ ? done - done_ : 0;
    per_second_ = steps_ > 0 ? std::optional(static_cast<double>(steps_) / seconds) : std::nullopt;
    left_ =
        steps_ > 0 && progress > 0 ? std::optional((1 - done) / progress * seconds) : std::nullopt;
    steps_ = 0;
    since_ = Clock::now();
    done_ = done;
    phase_ = protocol.state().phase;
  }
  std::optional<double> per_second() const { return per_second_; }
  std::optional<double> left() const { return left_; }  // of the phase [s]

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point since_ = Clock::now();
  std::int64_t steps_ = 0;
  double done_ = 0;  // share of the phase at the beginning of this second
  int phase_ = -1;
  std::optional<double> per_second_, left_;
};

}  // namespace quicksand
