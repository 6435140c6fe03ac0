// Measures time steps: as many as asked for, timed one by one without what surrounds them, or a single
// one.
#pragma once

#include <functional>
#include <string>

#include "app/bench/bench.h"
#include "core/protocol/protocol.h"
#include "core/scene/scenario.h"

namespace quicksand::bench {

struct Window {
  Row run{};            // a step that was tried as two halves counts once
  std::string failure;  // why it ended early; empty if it did not
};

struct WindowSettings {
  std::int64_t steps = 0;                          // at most
  double patience = 1e9;                           // wall time after which it is stopped [s]
  std::function<bool(const World&)> reached = {};  // ends it before that; asked after each step
};

// Advances the protocol, whose world and state hold the outcome.
Window measure_window(Protocol& protocol, const WindowSettings& settings, const Options& options);

// The next step of `world` alone, by a stepper that knows nothing yet. `report` is the step's own.
Row measure_step(World& world, const Scenario& scene, const Options& options, StepReport& report);

}  // namespace quicksand::bench
