// One line on standard error that says how far a computation is: written over on a terminal, repeated
// every ten seconds elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace quicksand {

// Whether a program reads standard error, by QUICKSAND_MESSAGES=json: errors are lines of JSON, and the status line is
// written over as on a terminal.
bool program_listens();

class StatusLine {
 public:
  enum class Style : std::uint8_t { none, lines, terminal };
  // What suits standard error.
  static Style style_of_stderr(bool quiet);

  explicit StatusLine(Style style) : style_(style) {}

  Style style() const { return style_; }
  // Whether it is time for another line.
  bool due() const;
  void show(const std::string& text);
  // Leaves the line that was written over.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  Style style_;
  Clock::time_point shown_ = Clock::now();
  std::size_t width_ = 0;  // of what stands on the terminal's line
};

// "0.31 s", "42 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

}  // namespace quicksand
