#include "app/series/sample_times.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

// Steps add up with rounding: a sample is due when the step's end comes this close to it, relative to
// the interval.
constexpr double kRounding = 1e-6;

constexpr double kSamples = 100;  // in a phase whose length is known
constexpr double kSamplesPerFall = 10;

double fall_time(const Scenario& scenario) {
  const double g = scenario.gravity ? scenario.gravity->norm() : 0;
  return g > 0 ? std::sqrt(2 * scenario.box.height / g) : 0;
}

struct Interval {
  const Scenario& scenario;

  double operator()(const DepositPhase& phase) const {
    const double interval = phase.adiabatic ? phase.adiabatic->max_interval : phase.interval;
    return static_cast<double>(estimated_grains(scenario, phase)) * interval / kSamples;
  }
  double operator()(const SettlePhase& phase) const {
    return phase.until_rest ? until_rest(phase.max_time) : phase.max_time / kSamples;
  }
  double operator()(const PushPhase& phase) const { return until_rest(phase.max_time); }
  double operator()(const PullPhase& phase) const { return until_rest(phase.trials.max_time); }
  double operator()(const ShearPhase& phase) const { return phase.trials.max_time; }
  double operator()(const HealPhase&) const { return 0; }
  double operator()(const PistonPhase& phase) const { return until_rest(phase.max_time); }
  double operator()(const PenetratePhase& phase) const {
    if (!phase.speed) return until_rest(phase.max_time);
    return std::min(phase.max_time, phase.ramp_time + phase.depth / *phase.speed) / kSamples;
  }
  double operator()(const VanePhase& phase) const {
    if (!phase.angular_velocity) return until_rest(phase.max_time);
    return std::min(phase.max_time, phase.ramp_time + phase.angle / *phase.angular_velocity) /
           kSamples;
  }

  double operator()(const SlidePhase& phase) const {
    return (phase.ramp_time / 2 + phase.distance / std::abs(phase.speed)) / kSamples;
  }

  double until_rest(double max_time) const {
    const double fall = fall_time(scenario) / kSamplesPerFall;
    return fall > 0 ? std::min(fall, max_time / kSamples) : max_time / kSamples;
  }
};

}  // namespace

std::int64_t estimated_grains(const Scenario& scenario, const DepositPhase& phase) {
  if (phase.height == 0) return phase.grains;
  constexpr double kLoose = 0.37;
  constexpr double kDense = 0.8;
  const double share = scenario.grain_law.cohesion_force ? kLoose : kDense;
  const double deviation = phase.polydispersity ? phase.polydispersity->deviation : 0;
  const double grain_area = std::numbers::pi / 4 * (1 + deviation * deviation);
  const auto room =
      static_cast<std::int64_t>(share * scenario.box.width * phase.height / grain_area);
  return phase.grains > 0 ? std::min(phase.grains, room) : room;
}

double sample_interval(const Scenario& scenario, const Phase& phase, std::optional<double> every) {
  const double dt = phase.dt.value_or(scenario.step.dt);
  const double interval = every                ? *every
                          : phase.sample_every ? *phase.sample_every
                                               : std::visit(Interval{scenario}, phase.kind);
  return std::max(interval, dt);  // not more than one a step
}

SampleTimes::SampleTimes(double start, double interval, double now)
    : start_(start),
      interval_(interval),
      next_(1 + static_cast<std::int64_t>(std::floor((now - start) / interval + kRounding))) {}

bool SampleTimes::due(double now) {
  if (now - start_ < (static_cast<double>(next_) - kRounding) * interval_) return false;
  next_ = 1 + static_cast<std::int64_t>(std::floor((now - start_) / interval_ + kRounding));
  return true;
}

}  // namespace quicksand
