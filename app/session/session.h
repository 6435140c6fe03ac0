// A simulation that one can talk to: a scene, where it stands, how it is looked at, and what was
// measured on the way. Commands change it; panels and pictures only read it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/json/json_text.h"
#include "app/series/sampled_run.h"
#include "app/session/timeline.h"
#include "render/base/view.h"

namespace quicksand {

class Session;

// What ends Session::run(); whatever comes first. Nothing given: the end of the scene.
struct RunUntil {
  std::optional<std::int64_t> steps;  // from now
  std::optional<double> time;         // from now [sqrt(d/g)]
  bool phase_end = false;             // of the present phase
  std::function<bool(const Session&)> condition;
};

enum class RunStop : std::uint8_t {
  steps,
  time,
  phase_end,
  condition,
  finished,  // the last phase ended
  failed,    // see Protocol::failure()
  cut_short  // by Session::stop_asked, or by `meanwhile` within a step
};
std::string_view word_of(RunStop stop);

class Session {
 public:
  // Starts a scene. Throws InputError if it cannot be simulated; the session is then as before.
  void load(const Scenario& scenario);
  bool loaded() const { return sampled_run_ != nullptr; }
  // Starts the scene again, as it was changed meanwhile.
  void reset();
  // Sets a value of the scene by its path, "contact.friction"; null removes it. Returns whether it holds
  // at once; else from the next reset on: bodies and box that are there stay, and so do the phases of a
  // run that has some begun by hand. Throws InputError.
  bool set(const std::string& path, const Json& value);
  // Takes the last change of a value back; returns as set() does. Throws InputError where there is none.
  bool undo();
  // The path of the value that undo() would take back; empty where there is none.
  std::string last_change() const {
    return changes_.empty() ? std::string() : changes_.back().path;
  }
  // Ends the present phase and begins this one; the phases not begun yet follow.
  void begin_phase(const Phase& phase);
  // The force on the centre of a body from now on, besides its weight [F_g], and the torque [F_g d]; absent: as before.
  void apply(int body, const std::optional<Vec2>& force, std::optional<double> torque);

  // Computes. Does nothing if the scene is finished or failed.
  RunStop run(const RunUntil& until);
  // Of the last run(), once: phases that ended after its last step, as those do that take none. To run as many steps
  // again would stop before them.
  int take_phases_ended_after_steps() { return std::exchange(phases_ended_after_steps_, 0); }
  // Asked after every step; true cuts a run short. May be empty.
  std::function<bool(const Session&)> stop_asked;
  // Called now and then while a step is solved, when the world is still as it was before the step. May change views, not
  // what is computed. True gives the step up, which cuts the run short. May be empty.
  std::function<bool()> meanwhile;
  bool is_to_end() const { return meanwhile && meanwhile(); }

  // A checkpoint with which run --continue goes on, too. Throw InputError.
  void save(const std::filesystem::path& file) const;
  void restore(const std::filesystem::path& file);

  // Shows a run that was computed before, or that another process computes, instead of computing. Throws InputError if
  // the folder holds none with a history; the session is then as before.
  void open(const std::filesystem::path& folder);
  // The run that is shown; null where the session computes.
  Timeline* timeline() { return timeline_.get(); }
  const Timeline* timeline() const { return timeline_.get(); }
  // Computes on from the checkpoint of the shown run that is nearest to the shown moment: its state.cbor, or its
  // beginning. Throws InputError.
  void go_on();

  // The scene with all its changes: what the next reset starts.
  const Scenario& scenario() const { return scenario_; }
  // The following must not be called unless loaded().
  const World& world() const { return timeline_ ? timeline_->world() : sampled_run_->world(); }
  const Protocol& protocol() const { return sampled_run_->protocol(); }
  // Phases of the present run: those of the scene, and those begun by hand.
  const std::vector<Phase>& phases() const { return protocol().scenario().phases; }
  // Of the present one; "end" after the last.
  std::string phase_name() const {
    return timeline_ ? timeline_->moment().phase_name : sampled_run_->phase_name();
  }
  bool failed() const { return failed_; }
  bool finished() const { return protocol().phase() == nullptr; }
  // Samples since the start, for plots: at most kMostSamples, thinned when there are more.
  static constexpr std::size_t kMostSamples = 1000;
  const std::vector<Values>& history() const { return timeline_ ? timeline_->rows() : history_; }
  // The quantities of this moment.
  Row measure_now() const;
  // What a search has found last, "11.9 to 12.1 F_g"; of a vane a torque. Empty if there is nothing, or if a run is shown.
  std::string newest_critical_force() const;
  // Samples this moment, unless it is sampled already.
  void sample();
  // Time between samples from now on; that of the scene if absent [sqrt(d/g)].
  void sample_every(std::optional<double> every);
  // Receives each sample as it is taken. May be empty.
  SampledRun::Sink on_sample;

  View view;  // of the packing, its size that of a picture without panel
  // Whether the scales of a run that is shown fit its whole history, not each moment by itself.
  bool scales_of_run = true;
  // The view with the scales of a run that is shown.
  View shown() const;
  std::optional<int> picked;  // body that is inspected
  bool running = false;       // whether each frame of a panel computes steps_per_frame
  std::int64_t steps_per_frame = 1;

 private:
  // Looks at a scene anew, whose world this is.
  void begin(const Scenario& scenario, World world);
  void start(const Scenario& scenario, Checkpoint checkpoint);
  void remember(const Row& row);
  void require_computing() const;
  void take_scene_into_view();
  // The scene as it is with another value at this path.
  bool take_over(const std::string& path, Scenario changed);

  // A change of a value of the scene, with the scene before it.
  struct Change {
    std::string path;
    Scenario before;
  };

  Scenario scenario_;
  std::vector<Change> changes_;  // since the scene was loaded; the first are forgotten
  std::unique_ptr<SampledRun> sampled_run_;
  std::unique_ptr<Timeline> timeline_;
  std::vector<Values> history_;
  std::size_t stride_ = 1;  // every which sample is kept in the history
  std::size_t samples_ = 0;
  std::optional<double> every_;  // between samples, if not as the scene says
  bool by_hand_ = false;         // whether phases were begun by hand
  int phases_ended_after_steps_ = 0;
  bool failed_ = false;
};

}  // namespace quicksand
