// Ctrl-C and `kill` ask a run to end after its present step. A second one ends the program at once.
#pragma once

namespace quicksand {

// Catches SIGINT and SIGTERM while at least one of its kind lives, in any thread: all of them see the
// signal, and it is forgotten when the last has gone.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const;
};

}  // namespace quicksand
