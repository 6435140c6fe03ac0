// The user's errors: what is wrong in an input, and where. Numerical outcomes are not errors but
// values in a StepReport; our own mistakes are assertions.
#pragma once

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

namespace quicksand {

// A number as messages show it.
inline std::string message_number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", x);
  return text.data();
}

// Thrown for bad input only. `path` names the place inside the input ("phases[1].force") or the input
// ("state.cbor"); `what()` says what is wrong, the allowed range and, if a name is unknown, the
// nearest valid one, which is also in `nearest`. The program turns it into exit code 2.
class InputError : public std::runtime_error {
 public:
  InputError(std::string path, const std::string& problem, std::string nearest = {})
      : std::runtime_error(problem),
        path_(std::move(path)),
        where_(path_),
        nearest_(std::move(nearest)) {}

  // The same inside a file; `note` says how the user can have put it there.
  InputError in(const std::string& file, const std::string& note = {}) const {
    InputError error(where_ == file ? std::string() : where_, what(), nearest_);
    error.file_ = file;
    error.where_ = file + (error.path_.empty() ? "" : ": " + error.path_) + note;
    return error;
  }

  const std::string& path() const { return path_; }
  const std::string& file() const { return file_; }  // empty: unknown, or in `path`
  // Both, as messages say it: "scene.json: phases[1].force (from --set)".
  const std::string& where() const { return where_; }
  const std::string& nearest() const { return nearest_; }  // empty: none

 private:
  std::string path_, where_, nearest_, file_;
};

}  // namespace quicksand
