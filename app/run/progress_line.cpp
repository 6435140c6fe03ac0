#include "app/run/progress_line.h"

#include "app/view/film.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

std::string present_bodies(const World& world) {
  return count_text(world.disks.size(), "body", "bodies");
}

std::string by_method(const Protocol& protocol) {
  const std::string method = method_label(protocol.scenario());
  return method.empty() ? "" : " (" + method + ")";
}

}  // namespace

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
  if (done > kEnough) left = "  at most " + duration_text(spent * (1 - share) / done) + " left";
  const double rate =
      since_shown > 0 ? static_cast<double>(world.step - shown_step_) / since_shown : 0;
  const ProtocolState& state = protocol.state();
  return format("%-7s %3.0f %%%s  t = %.4g  %s  %.0f steps/s  residual %.1e  unconverged %lld%s",
                std::string(phase_name(*protocol.phase())).c_str(), 100 * share, left.c_str(),
                world.time, present_bodies(world).c_str(), rate,
                protocol.last_step().solve.residual.natural,
                static_cast<long long>(state.unconverged_steps), by_method(protocol).c_str());
}

// The line at the beginning of a phase.
std::string ProgressLine::heading(const Protocol& protocol) {
  return format("%s begins at t = %.4g with %s%s",
                std::string(phase_name(*protocol.phase())).c_str(), protocol.world().time,
                present_bodies(protocol.world()).c_str(), by_method(protocol).c_str());
}

void ProgressLine::show(const Protocol& protocol) {
  if (line_.style() == Style::none || protocol.phase() == nullptr) return;
  const bool new_phase = protocol.state().phase != phase_;
  if (new_phase) begin_phase(protocol);
  const bool heads = new_phase && line_.style() == Style::lines;
  if (!line_.due() && !heads) return;
  line_.show(heads ? heading(protocol) : line(protocol, seconds(Clock::now() - shown_)));
  shown_ = Clock::now();
  shown_step_ = protocol.world().step;
}

}  // namespace quicksand
