#include "app/base/interrupt.h"

#include <atomic>
#include <csignal>
#include <mutex>

namespace quicksand {

namespace {

// A signal handler reaches nothing but what outlives every object.
std::atomic<bool> signalled = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void note_signal(int /*signal*/) { signalled = true; }

// The watches that live, and what they replaced.
struct Watched {
  std::mutex mutex;
  int watches = 0;
  struct sigaction before_int {};
  struct sigaction before_term {};
};

Watched& watched() {
  static Watched only;
  return only;
}

}  // namespace

InterruptWatch::InterruptWatch() {
  Watched& all = watched();
  const std::lock_guard lock(all.mutex);
  if (all.watches++ > 0) return;
  signalled = false;
  struct sigaction action {};
  action.sa_handler = note_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, &all.before_int);
  sigaction(SIGTERM, &action, &all.before_term);
}

InterruptWatch::~InterruptWatch() {
  Watched& all = watched();
  const std::lock_guard lock(all.mutex);
  if (--all.watches > 0) return;
  sigaction(SIGINT, &all.before_int, nullptr);
  sigaction(SIGTERM, &all.before_term, nullptr);
}

bool InterruptWatch::interrupted() const { return signalled; }

}  // namespace quicksand
