#include "app/bench/cases/window.h"

#include <algorithm>

namespace quicksand::bench {

Window measure_window(Protocol& protocol, const WindowSettings& settings, const Options& options) {
  Window window;
  Row& run = window.run;
  run.what = "steps";
  run.method = options.method;
  const ProtocolState before = protocol.state();
  const Stopwatch whole;
  ProgressLine line(options.progress);
  while (run.steps < settings.steps) {
    stop_if_interrupted();
    const std::int64_t step = protocol.world().step;
    const Stopwatch watch;
    const Progress progress = protocol.advance();
    run.seconds += watch.elapsed();
    if (progress == Progress::finished) break;
    const StepReport& report = protocol.last_step();
    if (progress == Progress::failed) {
      window.failure = protocol.failure();
      ++run.unconverged;
      break;
    }
    line.show(protocol);
    if (protocol.world().step == step) continue;  // a phase ended or began
    ++run.steps;
    run.residual = std::max(run.residual, report.solve.residual.natural);
    run.gap_error = std::max(run.gap_error, kGapUnit * report.solve.residual.gap);
    if (settings.reached && settings.reached(protocol.world())) break;
    if (whole.elapsed().wall > settings.patience) {
      window.failure =
          "stopped after " + std::to_string(static_cast<int>(settings.patience)) + " s";
      break;
    }
  }
  line.end();
  const ProtocolState& after = protocol.state();
  run.iterations = after.iterations - before.iterations;
  run.factorisations = after.factorisations - before.factorisations;
  run.unconverged +=
      after.unconverged_steps - before.unconverged_steps + after.halved_steps - before.halved_steps;
  run.size = std::ranges::count(protocol.world().disks.role, DiskRole::grain);
  run.contacts = static_cast<std::int64_t>(protocol.world().contacts.size());
  return window;
}

Row measure_step(World& world, const Scenario& scene, const Options& options, StepReport& report) {
  Stepper stepper;
  const Stopwatch watch;
  report = stepper.advance(world, scene.step, scene.solver);
  Row run{.what = "step", .method = options.method};
  run.seconds = watch.elapsed();
  run.contacts = static_cast<std::int64_t>(world.contacts.size());
  run.tolerance = scene.solver.tolerance;
  run.steps = 1;
  run.iterations = report.solve.iterations;
  run.factorisations = report.solve.factorisations;
  run.unconverged = report.converged ? 0 : 1;
  run.residual = report.solve.residual.natural;
  run.gap_error = kGapUnit * report.solve.residual.gap;
  return run;
}

}  // namespace quicksand::bench
