#include "app/run/run_scene.h"

#include <chrono>
#include <utility>

#include "app/interrupt.h"
#include "app/run/continuation.h"
#include "app/run/course.h"
#include "app/run/film.h"
#include "app/run/progress_line.h"
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

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

// One run: its course, and what writes it down.
class Run {
 public:
  Run(const Scenario& scenario, const RunOptions& options, const RunFolder& folder,
      Checkpoint start)
      : scenario_(scenario),
        options_(options),
        folder_(folder),
        first_step_(start.world.step),
        series_(folder.series(), resumed_step()),
        course_(scenario, std::move(start), options.every,
                [this](const Row& row, const World& world) { record(row, world); }) {
    if (options.frames) film_.emplace(folder, scenario, options.view, series_.rows());
  }

  RunResult complete() {
    RunResult result{folder_, {}, {}};
    try {
      result.end.how = compute();
      if (result.end.how == RunEnd::How::failed) result.end.failure = protocol().failure();
      result.notes = finish_film();
    } catch (const InputError& error) {
      fail(result.end, error);
    }
    result.end.steps = course_.world().step - first_step_;
    result.end.wall_seconds = seconds_since(began_);
    try {
      write_state();
      write_search_tables(folder_, protocol().state());
      const Json values =
          summary(scenario_, course_.world(), protocol().state(), course_.last(), result.end);
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
    return same ? std::optional(first_step_) : std::nullopt;
  }

  const Protocol& protocol() const { return course_.protocol(); }

  void record(const Row& row, const World& world) {
    // The earlier part of a continued run ended with this sample.
    if (std::exchange(first_sample_, false) && series_.last_step() == world.step) return;
    series_.add(row);
    if (film_) film_->add(world, row.phase);
  }

  RunEnd::How compute() {
    ProgressLine progress(StatusLine::style_of_stderr(options_.quiet));
    RunEnd::How how = RunEnd::How::finished;
    while (protocol().phase() != nullptr) {
      if (watch_.interrupted()) {
        how = RunEnd::How::interrupted;
        break;
      }
      progress.show(protocol());
      if (course_.advance() == Progress::failed) {
        how = RunEnd::How::failed;
        break;
      }
      if (seconds_since(checkpointed_) > kCheckpointPeriod) write_state();
    }
    course_.sample();
    progress.end();
    return how;
  }

  void write_state() {
    write_checkpoint(folder_.state(), {course_.world(), protocol().state(), to_text(scenario_)});
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
  std::int64_t first_step_;
  bool first_sample_ = true;
  Series series_;
  std::optional<Film> film_;
  Course course_;
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
