// Time of the calling thread and of the wall. A shared machine stretches the wall's time; figures are
// made of the thread's, and both are written down.
#pragma once

#include <chrono>
#include <ctime>

namespace quicksand::bench {

struct Seconds {
  double cpu = 0;   // of the calling thread [s]
  double wall = 0;  // [s]
  Seconds& operator+=(const Seconds& more) {
    cpu += more.cpu;
    wall += more.wall;
    return *this;
  }
};

class Stopwatch {
 public:
  Stopwatch() : cpu_(thread_time()), wall_(Clock::now()) {}

  // Since construction.
  Seconds elapsed() const {
    return {thread_time() - cpu_, std::chrono::duration<double>(Clock::now() - wall_).count()};
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double thread_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  double cpu_;
  Clock::time_point wall_;
};

}  // namespace quicksand::bench
