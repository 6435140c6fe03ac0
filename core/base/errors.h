// The user's errors: what is wrong in an input, and where. Numerical outcomes are not errors but
// values in a StepReport; our own mistakes are assertions.
#pragma once

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace quicksand {

// A number as messages show it.
inline std::string message_number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", x);
  return text.data();
}

// Thrown for bad input only. `where` names the place inside the input ("phases[1].force",
// "state.cbor"); `what()` says what is wrong, the allowed range and, if a name is unknown, the
// nearest valid one. The program turns it into exit code 2.
class InputError : public std::runtime_error {
 public:
  InputError(std::string where, const std::string& problem)
      : std::runtime_error(problem), where_(std::move(where)) {}
  const std::string& where() const { return where_; }

 private:
  std::string where_;
};

}  // namespace quicksand
