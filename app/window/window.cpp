#include "app/window/window.h"

#include <chrono>
#include <cstdio>
#include <optional>

#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/commands/console.h"
#include "app/run_folder/folder_lock.h"
#include "app/run_folder/run_folder.h"
#include "app/scene/opening.h"
#include "app/window/display.h"
#include "app/window/interaction_recording.h"
#include "app/window/recent_files.h"
#include "app/window/step_rate.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

class Window {
 public:
  explicit Window(const WindowOptions& options)
      : options_(options),
        folder_{options.out.empty() ? fs::path("out") / "window" : options.out},
        lock_(lock_run(folder_.path)),
        console_({folder_.path, fs::current_path()}, options.scale) {
    console_.given = [this](const Json& command) { remember(command); };
    console_.computed = [this](std::int64_t steps) {
      interactions_.add_steps(steps, console_.session().take_phases_ended_after_steps());
      rate_.add(steps, console_.session().protocol());
    };
    // What is commanded within a step is done right after it.
    console_.session().stop_asked = [this](const Session&) {
      return closed_ || console_.commands_wait() || watch_.interrupted();
    };
    console_.session().meanwhile = [this] {
      show_within_step();
      return closed_ || console_.step_is_given_up() || watch_.interrupted();
    };
    begin();
  }

  int complete() {
    display_ = open_display("quicksand", options_.width, options_.height);
    int lively = kLively;  // frames until the picture rests
    while (!console_.quit && !closed_ && !watch_.interrupted()) {
      if (!display_->poll(input_, lively > 0 || moves() ? 1 : kIdle)) break;
      if (display_->something_happened() || run_has_grown()) lively = kLively;
      if (lively > 0 || moves()) {
        show();
        --lively;
        if (Clock::now() - interactions_written_ > kRecordingPeriod) write_interactions();
      }
    }
    finish();
    return watch_.interrupted() ? kInterrupted : kFine;
  }

 private:
  // Whether the picture changes by itself.
  bool moves() {
    const Timeline* timeline = console_.session().timeline();
    return console_.session().running || (timeline != nullptr && timeline->playing);
  }

  // Looks now and then whether the run that is shown, which may still be computing, has new samples.
  bool run_has_grown() {
    Timeline* timeline = console_.session().timeline();
    if (timeline == nullptr || Clock::now() - looked_ < kLookPeriod) return false;
    looked_ = Clock::now();
    try {
      return timeline->refresh();
    } catch (const InputError& error) {
      console_.panel().show_refusal(error);
      return true;
    }
  }

  static constexpr std::chrono::milliseconds kLookPeriod{500};
  static constexpr const char* kHint =
      "Press space to run and to pause. Drag a grain to pull at it, turn the wheel to zoom.";
  static constexpr const char* kRunHint =
      "Press space to play and to pause, the arrows to go by one sample. Drag along the timeline.";
  static constexpr std::chrono::milliseconds kShortestFrame{20};  // within a step
  static constexpr std::chrono::milliseconds kLongestFreeze{50};
  static constexpr int kLively = 4;
  static constexpr int kIdle = 100;  // [ms]
  static constexpr std::chrono::seconds kRecordingPeriod{2};

  void begin() {
    console_.panel().set_recent(recent_.paths());
    if (!options_.record.empty()) try_to_write(options_.record);
    do_now(opening_command(options_.file));
    // A recording shows what a session does, nothing for the hand.
    if (console_.recording) return;
    console_.panel().show_hint(console_.session().timeline() != nullptr ? kRunHint : kHint);
  }

  void do_now(const Json& command) {
    console_.perform(command, options_.file);
    remember(command);
  }

  void remember(const Json& command) {
    interactions_.add(command);
    if (recent_.add(command)) console_.panel().set_recent(recent_.paths());
  }

  void show() {
    const Session& session = console_.session();
    if (session.loaded() && !session.running) rate_.add(0, session.protocol());
    console_.panel().set_rate(rate_.per_second(), rate_.left());
    shown_ = Clock::now();
    display_->present(console_.panel_frame(input_, display_->width(), display_->height()));
  }

  // The window does not freeze while a step takes long: it shows soon what a hand does.
  void show_within_step() {
    const Clock::duration frozen = Clock::now() - shown_;
    if (!display_ || closed_ || frozen < kShortestFrame) return;
    closed_ = !display_->poll(input_, 0);
    if (!display_->something_happened() && frozen < kLongestFreeze) return;
    display_->present(console_.look(input_, display_->width(), display_->height()));
    shown_ = Clock::now();
  }

  // Now and then: a screen that goes away must not take what was done with it.
  void write_interactions() {
    if (options_.record.empty() || interactions_.empty() || !console_.session().loaded()) return;
    const Session& session = console_.session();
    const Timeline* timeline = session.timeline();
    const auto shown = timeline ? std::optional(timeline->shown()) : std::nullopt;
    write_whole(options_.record, interactions_.session(session.world(), shown));
    interactions_written_ = Clock::now();
  }

  void finish() {
    console_.finish_recording();
    write_interactions();
    if (options_.record.empty() || interactions_.empty()) return;
    std::fprintf(stderr, "the recording is in %s; `quicksand session` replays it\n",
                 options_.record.c_str());
  }

  InterruptWatch watch_;
  bool closed_ = false;  // by the user
  const WindowOptions& options_;
  RunFolder folder_;
  FolderLock lock_;
  Console console_;
  std::unique_ptr<Display> display_;
  GuiInput input_;
  Clock::time_point shown_ = Clock::now();
  InteractionRecording interactions_;
  RecentFiles recent_{RecentFiles::usual_place()};
  Clock::time_point interactions_written_ = Clock::now();
  Clock::time_point looked_ = Clock::now();  // for new samples of a run
  StepRate rate_;
};

}  // namespace

int run_window(const WindowOptions& options) { return Window(options).complete(); }

}  // namespace quicksand
