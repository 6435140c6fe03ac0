#include "app/run/run_scene.h"

#include <chrono>

#include "app/interrupt.h"
#include "app/run/continuation.h"
#include "app/run/film.h"
#include "app/run/progress_line.h"
#include "app/run/recorder.h"
#include "app/run/sample_times.h"
#include "app/run/search_results.h"
#include "app/run/series.h"
#include "app/scene/scenario_json.h"
#include "app/scene/scene_file.h"
#include "core/errors.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// A run that is killed loses at most this. [s]
constexpr double kCheckpointPeriod = 60;

double seconds_since(Clock::time_point moment) {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

std::string name_of(const Phase* phase) {
  return phase != nullptr ? std::string(phase_name(*phase)) : std::string("end");
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

// One run: the protocol, and what writes down its course.
class Run {
 public:
  Run(const Scenario& scenario, const RunOptions& options, const RunFolder& folder,
      Checkpoint start)
      : scenario_(scenario),
        options_(options),
        folder_(folder),
        protocol_(scenario, std::move(start.world), start.protocol),
        series_(folder.series(), resumed_step()),
        recorder_(series_, begin_film()),
        first_step_(protocol_.world().step) {}

  RunResult complete() {
    RunResult result{folder_, {}, {}};
    try {
      result.end.how = compute();
      if (result.end.how == RunEnd::How::failed) result.end.failure = protocol_.failure();
      result.notes = finish_film();
    } catch (const InputError& error) {
      fail(result.end, error);
    }
    result.end.steps = protocol_.world().step - first_step_;
    result.end.wall_seconds = seconds_since(began_);
    try {
      write_state();
      write_search_tables(folder_, protocol_.state());
      const Json values =
          summary(scenario_, protocol_.world(), protocol_.state(), recorder_.last(), result.end);
      write_whole(folder_.summary(), values.dump(2) + "\n");
    } catch (const InputError& error) {
      fail(result.end, error);
    }
    return result;
  }

 private:
  // Results can no longer be written; what is left is to say so.
  static void fail(RunEnd& end, const InputError& error) {
    end.how = RunEnd::How::failed;
    end.failure = error.where() + ": " + error.what();
    end.unwritable = true;
  }

  // A run that goes on in its own folder appends to what is there.
  std::optional<std::int64_t> resumed_step() const {
    const bool same =
        options_.continued_from && same_file(*options_.continued_from, folder_.state());
    return same ? std::optional(protocol_.world().step) : std::nullopt;
  }

  Film* begin_film() {
    if (!options_.frames) return nullptr;
    film_.emplace(folder_, scenario_, options_.view, series_.rows());
    return &*film_;
  }

  RunEnd::How compute() {
    ProgressLine progress(StatusLine::style_of_stderr(options_.quiet));
    recorder_.sample(protocol_.world(), name_of(protocol_.phase()));
    RunEnd::How how = RunEnd::How::finished;
    while (protocol_.phase() != nullptr) {
      if (watch_.interrupted()) {
        how = RunEnd::How::interrupted;
        break;
      }
      progress.show(protocol_);
      if (advance() == Progress::failed) {
        how = RunEnd::How::failed;
        break;
      }
      if (seconds_since(checkpointed_) > kCheckpointPeriod) write_state();
    }
    recorder_.sample(protocol_.world(), phase_);
    progress.end();
    return how;
  }

  // One step, with its sample if one is due.
  Progress advance() {
    const ProtocolState before = protocol_.state();
    const std::int64_t step_before = protocol_.world().step;
    const double time_before = protocol_.world().time;
    const Phase& phase = *protocol_.phase();
    phase_ = name_of(&phase);
    if (before.phase != times_of_) {
      times_ = SampleTimes(before.entered ? before.phase_start : time_before,
                           sample_interval(scenario_, phase, options_.every), time_before);
      times_of_ = before.phase;
    }
    const Progress progress = protocol_.advance();
    const World& world = protocol_.world();
    if (world.step != step_before) recorder_.count(before, protocol_);
    if (times_.due(world.time)) recorder_.sample(world, phase_);
    if (progress == Progress::phase_ended) recorder_.sample(world, phase_);
    return progress;
  }

  void write_state() {
    write_checkpoint(folder_.state(), {protocol_.world(), protocol_.state(), to_text(scenario_)});
    checkpointed_ = Clock::now();
  }

  std::string finish_film() {
    if (!film_) return {};
    const VideoReport video = film_->finish();
    return video.message;
  }

  InterruptWatch watch_;
  const Scenario& scenario_;
  const RunOptions& options_;
  RunFolder folder_;
  Protocol protocol_;
  Series series_;
  std::optional<Film> film_;
  Recorder recorder_;
  std::int64_t first_step_;
  std::string phase_ = "start";
  SampleTimes times_{0, 1, 0};
  int times_of_ = -1;  // phase that `times_` belongs to
  Clock::time_point began_ = Clock::now();
  Clock::time_point checkpointed_ = Clock::now();
};

}  // namespace

RunResult run_scene(const Scenario& scenario, const RunOptions& options) {
  const RunFolder folder{options.out.empty() ? fs::path("out") / scenario.name : options.out};
  Checkpoint start;
  if (options.continued_from) {
    start = read_continuation(*options.continued_from, scenario);
  } else {
    start.world = start_world(scenario);
  }
  const bool goes_on_here =
      options.continued_from && same_file(*options.continued_from, folder.state());
  if (!scenario.start_from.empty() && same_file(scenario.start_from, folder.state())) {
    throw InputError(folder.state().string(),
                     "is what the scene starts from and would be overwritten; choose another "
                     "folder with --out");
  }
  make_writable(folder);
  if (!goes_on_here) remove_earlier_results(folder);
  write_whole(folder.scene(), to_text(scenario));
  return Run(scenario, options, folder, std::move(start)).complete();
}

}  // namespace quicksand
