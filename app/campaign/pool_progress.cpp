#include "app/campaign/pool_progress.h"

#include <string>

namespace quicksand {

void PoolProgress::count(bool computed, bool failed) {
  ++ended_;
  if (computed) ++computed_;
  if (failed) ++failed_;
}

void PoolProgress::show(std::size_t running) {
  if (!line_.due()) return;
  std::string text = std::to_string(ended_) + " of " + std::to_string(jobs_) + " runs done";
  if (failed_ > 0) text += ", " + std::to_string(failed_) + " failed";
  text += ", " + std::to_string(running) + " running";
  // Runs of the same campaign take about the same time; those that were done before cost nothing.
  if (computed_ > 0) {
    const double spent = std::chrono::duration<double>(Clock::now() - began_).count();
    const auto left = static_cast<double>(jobs_ - ended_);
    text += "  about " + duration_text(spent * left / static_cast<double>(computed_)) + " left";
  }
  line_.show(text);
}

}  // namespace quicksand
