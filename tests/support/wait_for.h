// Waiting that ends: for another process or thread, with words for what did not come.
#pragma once

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

namespace quicksand::test {

// Far beyond what any test waits for on a loaded machine with sanitizers.
inline constexpr std::chrono::seconds kLongestWait{120};

// Asks every millisecond until `condition()` holds. Throws, which fails the test, if that takes too long.
template <class Condition>
void wait_for(const std::string& what, Condition condition) {
  const auto end = std::chrono::steady_clock::now() + kLongestWait;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end)
      throw std::runtime_error("waited for " + what + " for " +
                               std::to_string(kLongestWait.count()) + " s");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace quicksand::test
