// Ctrl-C and `kill` ask a run to end after its present step. A second one ends the program at once.
#pragma once

#include <csignal>

namespace quicksand {

// Catches SIGINT and SIGTERM while it lives.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const;

 private:
  struct sigaction before_int_ {};
  struct sigaction before_term_ {};
};

}  // namespace quicksand
