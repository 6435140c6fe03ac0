#include "app/run/run_scene.h"

#include <chrono>
#include <exception>
#include <new>
#include <optional>
#include <utility>

#include "app/base/interrupt.h"
#include "app/base/shell_text.h"
#include "app/history/history_writer.h"
#include "app/json/json_reader.h"
#include "app/run/continuation.h"
#include "app/run/progress_line.h"
#include "app/run/resumption.h"
#include "app/run/run_position.h"
#include "app/run_folder/folder_lock.h"
#include "app/run_folder/search_results.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_report.h"
#include "app/scene_json/scenario_json.h"
#include "app/series/sampled_run.h"
#include "app/series/series.h"
#include "app/view/film.h"
#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/base/whole_file.h"
#include "core/world/extent.h"
#include "render/picture/frame.h"
#include "render/picture/renderer.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kMegabyte = 1e6;  // [bytes]

double seconds_since(Clock::time_point moment) {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

void fail(RunEnd& end, RunEnd::Cause cause, const std::string& failure) {
  end.how = RunEnd::How::failed;
  end.cause = cause;
  end.failure = failure;
}
void fail(RunEnd& end, RunEnd::Cause cause, const InputError& error) {
  fail(end, cause, error.where() + ": " + error.what());
}

// One run: its steps and samples, and the files that record them.
class Run {
 public:
  // `earlier`: where the run stands that goes on in its own folder, for which it has computed so long [s].
  Run(const Scenario& scenario, const RunOptions& options, const RunFolder& folder,
      Checkpoint start, const std::optional<RunPosition>& earlier, double earlier_seconds)
      : scenario_(scenario),
        options_(options),
        folder_(folder),
        first_step_(earlier ? earlier->first_step : start.world.step),
        began_at_step_(start.world.step),
        earlier_seconds_(earlier_seconds),
        series_(folder.series(), earlier ? earlier->rows : 0),
        sampled_run_(scenario, std::move(start), options.every,
                     [this](const Row& row, const World& world) { record(row, world); }) {
    if (options.continued_from) {
      sampled_run_.protocol().change(scenario);
      sampled_run_.protocol().take_push_force();
    }
    if (earlier) sampled_run_.go_on(earlier->samples);
    if (options.history_limit > 0)
      history_.emplace(folder.history(), series_.rows(),
                       static_cast<std::int64_t>(options.history_limit * kMegabyte));
    if (options.frames) film_.emplace(folder, scenario, options.view, series_.rows());
  }

  // The state speaks of rows and frames, so these are on the disk before it.
  void write_state() {
    const WorkClock::Span span(&clock(), Work::writing);
    series_.secure();
    if (history_) history_->secure();
    if (film_) {
      const WorkClock::Span until_there(&clock(), Work::waiting);
      film_->secure();
    }
    keep_computing_time(folder_, earlier_seconds_ + seconds_since(began_));
    write_checkpoint(
        folder_.state(),
        {sampled_run_.world(), protocol().state(), to_text(scenario_),
         to_bytes({series_.rows(), series_.checksum(), first_step_, sampled_run_.samples()})});
    checkpointed_ = Clock::now();
  }

  RunResult complete() {
    RunResult result{.folder = folder_};
    result.most_halvings = scenario_.step.max_halvings;
    try {
      result.end.how = compute();
      if (result.end.how == RunEnd::How::failed) result.end.failure = protocol().failure();
      // Phases before the last are often cut short on purpose.
      result.end.missed_rest = result.end.how == RunEnd::How::finished && protocol().missed_rest();
      if (result.end.missed_rest)
        result.notes.push_back("the last phase (" +
                               std::string(phase_name(scenario_.phases.back())) +
                               ") ended at its max_time, before it came to rest");
      std::ranges::move(scene_warnings(scenario_), std::back_inserter(result.notes));
      const std::string method =
          nscd_note(scenario_, protocol().state(), sampled_run_.world().step - first_step_);
      if (!method.empty()) result.notes.push_back(method);
      if (const std::string doubts = validate_now({});
          method.empty() && !options_.strict && !doubts.empty())
        result.notes.push_back("validation failed: " + doubts);
      std::ranges::move(moving_bases_, std::back_inserter(result.notes));
      std::ranges::move(
          search_warnings(search_results(scenario_, protocol().state()), protocol().state().phase),
          std::back_inserter(result.notes));
      if (film_ && higher_than_the_picture())
        result.notes.push_back("the packing is higher than box.height, " +
                               number_text(scenario_.box.height) + " d, where the pictures end");
      if (film_) {
        const WorkClock::Span span(&clock(), Work::waiting);
        if (std::string problem = film_->finish(); !problem.empty())
          result.notes.push_back(std::move(problem));
      }
    } catch (const PhaseRefused& error) {
      fail(result.end, Cause::scene, error);
    } catch (const InputError& error) {
      fail(result.end, Cause::disk_full, error);
    } catch (const NotEnoughMemory& error) {
      fail(result.end, Cause::memory, error.what());
    } catch (const std::bad_alloc&) {
      fail(result.end, Cause::memory, "there is not enough memory for the next step");
    } catch (const std::exception& error) {
      fail(result.end, Cause::unexpected, error.what());
    }
    if (result.end.cause == Cause::memory || result.end.cause == Cause::unexpected) try_to_keep();
    const std::int64_t step = sampled_run_.world().step;
    result.end.steps = step - first_step_;
    result.end.computed_steps = step - began_at_step_;
    result.end.last_wall_seconds = seconds_since(began_);
    result.end.wall_seconds = earlier_seconds_ + result.end.last_wall_seconds;
    result.end.work = clock().seconds();
    result.end.work_counts = clock().counts;
    const Row& last = sampled_run_.last();
    try {
      write_search_tables(folder_, protocol().state());
      const Json values =
          summary(scenario_, sampled_run_.world(), protocol().state(), last, result.end);
      write_whole(folder_.summary(), values.dump(2) + "\n");
      forget_computing_time(folder_);
    } catch (const InputError& error) {
      fail(result.end, Cause::disk_full, error);
    }
    if (options_.strict) result.invalid = validate_now(*options_.strict);
    return result;
  }

 private:
  using Cause = RunEnd::Cause;

  // After a failure of which none of the files need be at fault: the last whole step. The one before stays if it fails, too.
  void try_to_keep() {
    try {
      write_state();
    } catch (const std::exception&) {
    }
  }

  const Protocol& protocol() const { return sampled_run_.protocol(); }
  WorkClock& clock() { return sampled_run_.protocol().clock(); }

  std::string validate_now(const StrictBounds& bounds) const {
    return validation_failures(protocol().state(), sampled_run_.last().sample, bounds);
  }

  void record(const Row& row, const World& world) {
    {
      const WorkClock::Span span(&clock(), Work::writing);
      // First the state, then the row: what the series says of, the history has.
      if (history_) history_->add(world, series_.rows(), sampled_run_.phase_index(), row.phase);
      series_.add(values_of(row));
    }
    if (!film_) return;
    const WorkClock::Span span(&clock(), Work::drawing);
    film_->add(world, row.phase);
  }

  RunEnd::How compute() {
    ProgressLine progress(StatusLine::style_of_stderr(options_.quiet));
    RunEnd::How how = RunEnd::How::finished;
    clock().meanwhile = [this] { return watch_.interrupted(); };
    while (protocol().phase() != nullptr) {
      if (watch_.interrupted()) {
        how = RunEnd::How::interrupted;
        break;
      }
      progress.show(protocol());
      if (options_.watch) options_.watch(protocol());
      const Progress made = sampled_run_.advance();
      if (made == Progress::given_up) continue;
      if (made == Progress::failed) {
        how = RunEnd::How::failed;
        break;
      }
      if (made == Progress::phase_ended) look_at_base();
      if (made == Progress::phase_ended ||
          seconds_since(checkpointed_) >= options_.checkpoint_every)
        write_state();
    }
    // The sample of an early end is not one of the whole run: who goes on drops it.
    if (how != RunEnd::How::finished) write_state();
    sampled_run_.sample();
    if (how == RunEnd::How::finished) write_state();
    progress.end();
    return how;
  }

  // Trials compare forces only if what they begin from would stand by itself.
  void look_at_base() {
    const Phase* next = protocol().phase();
    if (!next || !protocol().missed_rest()) return;
    if (!is_of_force(search_kind(*next))) return;
    moving_bases_.push_back("phase " + std::to_string(protocol().state().phase - 1) +
                            " ended at its max_time, before it came to rest: the trials of " +
                            std::string(phase_name(*next)) + " begin with moving bodies");
  }

  bool higher_than_the_picture() const {
    const Box& box = scenario_.box;
    return box.width > 0 && box.height > 0 && packing_top(sampled_run_.world()) > box.height + 1;
  }

  InterruptWatch watch_;
  const Scenario& scenario_;
  const RunOptions& options_;
  RunFolder folder_;
  std::int64_t first_step_;     // of the run
  std::int64_t began_at_step_;  // of this part of it
  double earlier_seconds_;      // of the parts before it
  Series series_;
  std::optional<HistoryWriter> history_;
  std::optional<Film> film_;
  SampledRun sampled_run_;
  std::vector<std::string> moving_bases_;  // a sentence for each search that begins in motion
  Clock::time_point began_ = Clock::now();
  Clock::time_point checkpointed_ = Clock::now();
};

// Where the run stands that left this state.
RunPosition position_of(const Checkpoint& checkpoint, const fs::path& state) {
  if (const auto position = position_from(checkpoint.samples)) return *position;
  throw InputError(state.string(),
                   "was not written by a run; continue from it in another folder with --out");
}

// What goes on, before anything of it is touched.
void require_kept(const RunFolder& folder, const RunPosition& position, const RunOptions& options) {
  if (lacks_rows(folder, position))
    throw InputError(folder.series().string(),
                     "has other columns or rows than the run to be continued; continue it in "
                     "another folder with --out");
  if (options.history_limit > 0) refuse_unreadable(folder.history());
  if (!options.frames) return;
  const auto missing = missing_frame(folder, position.rows);
  if (!missing) return;
  throw InputError(missing->string(),
                   "is missing or damaged, although the run has passed it; continue with "
                   "--no-frames, or in another folder with --out");
}

// Throws RenderError if this system cannot draw, InputError if it cannot draw the view.
void require_pictures(const Scenario& scenario, const View& view) {
  check(view_of(scenario, view));
  const Renderer first;
}

}  // namespace

RunResult run_scene(const Scenario& scenario, const RunOptions& options) {
  const RunFolder folder{options.out.empty() ? fs::path("out") / scenario.name : options.out};
  Checkpoint start;
  std::optional<RunPosition> earlier;
  if (options.continued_from) {
    start = read_continuation(*options.continued_from, scenario);
    if (same_file(*options.continued_from, folder.state()))
      earlier = position_of(start, folder.state());
  } else {
    start.world = start_world(scenario);
  }
  if (!scenario.start_from.empty() && same_file(scenario.start_from, folder.state())) {
    throw InputError(
        folder.state().string(),
        "is what the scene starts from and would be overwritten; choose another folder with --out");
  }
  make_writable(folder);
  std::optional<FolderLock> lock;
  if (options.lock) lock.emplace(lock_run(folder.path));
  if (options.keep_earlier && !earlier && holds_run(folder)) {
    const std::string name = shell_text(folder.path);
    throw InputError(folder.path.string(),
                     "already holds a run; continue it with `" + program_name() + " resume " +
                         name +
                         "`, replace it with --overwrite, or choose another folder with --out");
  }
  // What can fail, before earlier results are lost by it.
  const std::string scene = to_text(scenario);
  if (options.frames && holds_run(folder)) require_pictures(scenario, options.view);
  double earlier_seconds = 0;
  if (earlier) {
    require_kept(folder, *earlier, options);
    earlier_seconds = computing_time_of(folder);
    keep_computing_time(folder, earlier_seconds);
    forget_end(folder);
  } else {
    remove_earlier_results(folder);
  }
  write_options(folder.options(), options);
  const auto write_scene = [&] { write_whole(folder.scene(), scene); };
  if (!options.continued_from) write_scene();
  std::optional<Run> run;
  try {
    run.emplace(scenario, options, folder, std::move(start), earlier, earlier_seconds);
    if (options.continued_from) {
      // The scene alone would begin anew, if this is killed before its first checkpoint.
      run->write_state();
      write_scene();
    }
  } catch (const DiskFull& error) {
    if (options.continued_from) throw;  // the same command does it
    // It would now find a run in the folder.
    RunResult result{.folder = folder};
    fail(result.end, RunEnd::Cause::disk_full, error);
    return result;
  }
  return run->complete();
}

}  // namespace quicksand
