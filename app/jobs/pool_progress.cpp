#include "app/jobs/pool_progress.h"

#include "core/base/format.h"

namespace quicksand {

void PoolProgress::count(bool computed, bool failed) {
  ++ended_;
  if (computed) ++computed_;
  if (failed) ++failed_;
}

std::string PoolProgress::text(std::span<const RunUnderWay> running, double spent) const {
  std::string text = std::to_string(ended_) + " of " + std::to_string(jobs_) + " runs done";
  if (failed_ > 0) text += ", " + std::to_string(failed_) + " failed";
  text += ", " + std::to_string(running.size()) + " running";
  // As if runs took about the same time; those that were done before cost nothing.
  auto done = static_cast<double>(computed_);
  auto left = static_cast<double>(jobs_ - ended_ - running.size());
  for (const RunUnderWay& run : running) {
    done += run.now_done;
    left += run.left;
  }
  // Too early an estimate is worse than none.
  constexpr double kEnough = 0.1;
  if (done > kEnough) text += "  about " + duration_text(spent * left / done) + " left";
  if (!running.empty() && !running.front().phase.empty()) {
    const RunUnderWay& first = running.front();
    const std::string percent = format("%.0f %%", 100 * first.phase_done);
    text += "  (" + std::string(first.id) + ": " + std::string(first.phase) + " " + percent + ")";
  }
  return text;
}

void PoolProgress::show(std::span<const RunUnderWay> running) {
  line_.show(text(running, std::chrono::duration<double>(Clock::now() - began_).count()));
}

}  // namespace quicksand
