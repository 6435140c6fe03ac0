#include "app/base/status_line.h"

#include <unistd.h>

#include <array>
#include <cstdio>

namespace quicksand {

namespace {

constexpr double kTerminalPeriod = 0.2;  // [s]
constexpr double kLinesPeriod = 10;      // [s]

}  // namespace

std::string duration_text(double seconds) {
  std::array<char, 32> text{};
  if (seconds < 100) {
    std::snprintf(text.data(), text.size(), "%.0f s", seconds);
  } else if (seconds < 6000) {
    std::snprintf(text.data(), text.size(), "%.0f min", seconds / 60);
  } else {
    std::snprintf(text.data(), text.size(), "%.1f h", seconds / 3600);
  }
  return text.data();
}

StatusLine::Style StatusLine::style_of_stderr(bool quiet) {
  if (quiet) return Style::none;
  return isatty(STDERR_FILENO) == 1 ? Style::terminal : Style::lines;
}

bool StatusLine::due() const {
  if (style_ == Style::none) return false;
  const double since = std::chrono::duration<double>(Clock::now() - shown_).count();
  return since >= (style_ == Style::terminal ? kTerminalPeriod : kLinesPeriod);
}

void StatusLine::show(const std::string& text) {
  if (style_ == Style::none) return;
  if (style_ == Style::terminal) {
    const std::string blanks(width_ > text.size() ? width_ - text.size() : 0, ' ');
    std::fprintf(stderr, "\r%s%s", text.c_str(), blanks.c_str());
    width_ = text.size();
  } else {
    std::fprintf(stderr, "%s\n", text.c_str());
  }
  std::fflush(stderr);
  shown_ = Clock::now();
}

void StatusLine::end() {
  if (width_ == 0) return;
  std::fprintf(stderr, "\r%s\r", std::string(width_, ' ').c_str());
  std::fflush(stderr);
  width_ = 0;
}

}  // namespace quicksand
