#include "app/base/status_line.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/base/format.h"

namespace quicksand {

namespace {

constexpr double kTerminalPeriod = 0.2;  // [s]
constexpr double kLinesPeriod = 10;      // [s]

}  // namespace

bool program_listens() {
  const char* form = std::getenv("QUICKSAND_MESSAGES");
  return form != nullptr && std::string_view(form) == "json";
}

std::string duration_text(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  const double whole = std::round(seconds);
  if (seconds < 10) return format("%.2g s", seconds);
  if (whole < kMinute) return format("%.0f s", whole);
  if (whole < kHour)
    return format("%.0f min %.0f s", std::floor(whole / kMinute), std::fmod(whole, kMinute));
  return format("%.0f h %.0f min", std::floor(whole / kHour),
                std::floor(std::fmod(whole, kHour) / kMinute));
}

StatusLine::Style StatusLine::style_of_stderr(bool quiet) {
  if (quiet) return Style::none;
  return isatty(STDERR_FILENO) == 1 || program_listens() ? Style::terminal : Style::lines;
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
