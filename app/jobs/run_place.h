// Where a run is, so that others see it: written by the thread that computes the run.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "app/jobs/job.h"
#include "app/jobs/pool_progress.h"
#include "core/protocol/protocol.h"

namespace quicksand {

class RunPlace {
 public:
  explicit RunPlace(const Job& job) : job_(job) {}

  // While there is a phase to compute.
  void note(const Protocol& protocol) {
    phase_ = protocol.state().phase;
    phase_done_ = protocol.phase_progress();
    const double done = (phase_ + phase_done_) / static_cast<double>(job_.scenario.phases.size());
    if (began_at_ < 0) began_at_ = done;
    done_ = done;
  }

  // By any thread.
  RunUnderWay seen() const {
    const int phase = phase_;
    if (phase < 0) return {.id = job_.id};
    return {job_.id, phase_name(job_.scenario.phases[static_cast<std::size_t>(phase)]), phase_done_,
            std::max(0.0, done_ - began_at_), 1 - done_};
  }

 private:
  const Job& job_;
  std::atomic<int> phase_ = -1;
  std::atomic<double> phase_done_ = 0;
  std::atomic<double> done_ = 0;       // share of the whole run, as if phases took the same time
  std::atomic<double> began_at_ = -1;  // the same, where it was taken up
};

}  // namespace quicksand
