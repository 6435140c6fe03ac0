#include "app/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace quicksand {

namespace {

constexpr double kTerminalPeriod = 0.2;  // [s]
constexpr double kLinesPeriod = 10;      // [s]

std::string duration(double seconds) {
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

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

ProgressLine::Style ProgressLine::style_of_stderr(bool quiet) {
  if (quiet) return Style::none;
  return isatty(STDERR_FILENO) == 1 ? Style::terminal : Style::lines;
}

ProgressLine::ProgressLine(Style style) : style_(style), shown_(Clock::now()) {}

void ProgressLine::begin_phase(const Protocol& protocol) {
  phase_ = protocol.state().phase;
  phase_began_ = Clock::now();
  phase_began_at_ = protocol.phase_progress();
}

std::string ProgressLine::line(const Protocol& protocol, double since_shown) {
  const World& world = protocol.world();
  const double share = protocol.phase_progress();
  const double done = share - phase_began_at_;
  const double spent = seconds(Clock::now() - phase_began_);
  std::string left;
  // Too early an estimate is worse than none. Phases that end at rest may end before their max_time.
  constexpr double kEnough = 0.01;
  if (done > kEnough) left = "  at most " + duration(spent * (1 - share) / done) + " left";
  const double rate =
      since_shown > 0 ? static_cast<double>(world.step - shown_step_) / since_shown : 0;
  const ProtocolState& state = protocol.state();
  std::array<char, 200> text{};
  std::snprintf(
      text.data(), text.size(),
      "%-7s %3.0f %%%s  t = %.4g  %d bodies  %.0f steps/s  residual %.1e  unconverged %lld",
      std::string(phase_name(*protocol.phase())).c_str(), 100 * share, left.c_str(), world.time,
      world.disks.size(), rate, protocol.last_step().solve.residual.natural,
      static_cast<long long>(state.unconverged_steps));
  return text.data();
}

// The line at the beginning of a phase.
std::string ProgressLine::heading(const Protocol& protocol) {
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "%s begins at t = %.4g with %d bodies",
                std::string(phase_name(*protocol.phase())).c_str(), protocol.world().time,
                protocol.world().disks.size());
  return text.data();
}

void ProgressLine::show(const Protocol& protocol) {
  if (style_ == Style::none || protocol.phase() == nullptr) return;
  const bool new_phase = protocol.state().phase != phase_;
  if (new_phase) begin_phase(protocol);
  const double since_shown = seconds(Clock::now() - shown_);
  const double period = style_ == Style::terminal ? kTerminalPeriod : kLinesPeriod;
  const bool heads = new_phase && style_ == Style::lines;
  if (since_shown < period && !heads) return;
  const std::string text = heads ? heading(protocol) : line(protocol, since_shown);
  if (style_ == Style::terminal) {
    const std::string blanks(width_ > text.size() ? width_ - text.size() : 0, ' ');
    std::fprintf(stderr, "\r%s%s", text.c_str(), blanks.c_str());
    width_ = text.size();
  } else {
    std::fprintf(stderr, "%s\n", text.c_str());
  }
  std::fflush(stderr);
  shown_ = Clock::now();
  shown_step_ = protocol.world().step;
}

void ProgressLine::end() {
  if (style_ != Style::terminal || width_ == 0) return;
  std::fprintf(stderr, "\r%s\r", std::string(width_, ' ').c_str());
  std::fflush(stderr);
  width_ = 0;
}

}  // namespace quicksand
