#include "app/session/session.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "app/run/continuation.h"
#include "app/run_folder/state_file.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_override.h"
#include "app/scene_json/scenario_json.h"
#include "app/series/thinning.h"
#include "app/view/film.h"
#include "core/base/errors.h"
#include "core/base/format.h"
#include "core/scene/validate.h"

namespace quicksand {

namespace {

// A part of a scene that a running simulation takes over; the others say how it begins.
struct PartThatHolds {
  std::string_view key;
  void (*take)(Scenario& run, const Scenario& changed);
};
template <auto Scenario::*Part>
void take(Scenario& run, const Scenario& changed) {
  run.*Part = changed.*Part;
}
constexpr auto kHoldAtOnce = std::to_array<PartThatHolds>({
    {"contact", take<&Scenario::grain_law>},
    {"wall_contact", take<&Scenario::wall_law>},
    {"intruder_contact", take<&Scenario::intruder_law>},
    {"gravity", take<&Scenario::gravity>},
    {"drag", take<&Scenario::drag>},
    {"step", take<&Scenario::step>},
    {"method", take<&Scenario::step>},
    {"nscd", take<&Scenario::step>},
    {"solver", take<&Scenario::solver>},
    {"phases", take<&Scenario::phases>},
    {"physical", take<&Scenario::physical>},
});

constexpr std::size_t kMostChanges = 100;  // that can be taken back

bool holds_at_once(const std::string& path) {
  const std::string part = path.substr(0, path.find_first_of(".["));
  return std::ranges::find(kHoldAtOnce, part, &PartThatHolds::key) != kHoldAtOnce.end();
}

// The scene of the present run with those parts of a changed one.
Scenario with_parts_that_hold(Scenario run, const Scenario& changed) {
  for (const PartThatHolds& part : kHoldAtOnce) part.take(run, changed);
  return run;
}

// Whether phases differ that have ended, or a field that the present one has made use of when it began.
bool is_too_late(const Scenario& before, const Scenario& after, const Protocol& protocol) {
  const Json old = to_json(before).at("phases"), changed = to_json(after).at("phases");
  const auto present = static_cast<std::size_t>(protocol.state().phase);
  for (std::size_t k = 0; k < std::min({present, old.size(), changed.size()}); ++k)
    if (old[k] != changed[k]) return true;
  const Phase* now = protocol.phase();
  if (!now || !protocol.state().entered || std::min(old.size(), changed.size()) <= present)
    return false;
  return std::ranges::any_of(set_up_by(*now), [&](const std::string& key) {
    return old[present].value(key, Json()) != changed[present].value(key, Json());
  });
}

// Whether the phases that have begun are of the same kinds in both; where all have ended, whether all are.
bool same_kinds(const std::vector<Phase>& a, const std::vector<Phase>& b, int present) {
  const auto begun = static_cast<std::size_t>(present) + 1;
  const auto first = [&](const std::vector<Phase>& phases) {
    return std::span(phases).first(std::min(begun, phases.size()));
  };
  if (std::min(a.size(), b.size()) < begun && a.size() != b.size()) return false;
  return std::ranges::equal(
      first(a), first(b), {}, [](const Phase& p) { return p.kind.index(); },
      [](const Phase& q) { return q.kind.index(); });
}

// Throws InputError, `path`, if the run would go on by NSCD with an intruder of several parts, or come to one.
void refuse_shapes_in_nscd(const Scenario& now, const Protocol& run, const std::string& path) {
  refuse_swept_shapes(now, run.world(), path);
  if (!now.step.nscd) return;
  for (auto k = static_cast<std::size_t>(run.state().phase); k < now.phases.size(); ++k)
    if (brings_shaped_intruder(now.phases[k]))
      throw InputError(path, "phases[" + std::to_string(k) +
                                 "] of the run brings an intruder of several parts, but nscd "
                                 "handles only disks and walls");
}

// Those of earlier steps.
std::vector<Values> rows_before(const std::vector<Values>& rows, std::int64_t step) {
  const std::size_t place = place_of("step");
  std::vector<Values> before;
  for (const Values& row : rows)
    if (number_in(row[place]).value_or(0) < static_cast<double>(step)) before.push_back(row);
  return before;
}

}  // namespace

std::string_view word_of(RunStop stop) {
  constexpr auto kWords = std::to_array<std::string_view>(
      {"steps", "time", "phase_end", "condition", "finished", "failed", "cut_short"});
  return kWords.at(static_cast<std::size_t>(stop));
}

void Session::start(const Scenario& scenario, Checkpoint checkpoint) {
  timeline_.reset();
  history_.clear();
  stride_ = 1;
  samples_ = 0;
  by_hand_ = failed_ = running = false;
  picked.reset();
  sampled_run_ = std::make_unique<SampledRun>(scenario, std::move(checkpoint), every_,
                                              [this](const Row& row, const World& world) {
                                                remember(row);
                                                if (on_sample) on_sample(row, world);
                                              });
  sampled_run_->sample();
}

void Session::remember(const Row& row) {
  if (samples_++ % stride_ != 0) return;
  history_.push_back(values_of(row));
  if (history_.size() < kMostSamples) return;
  keep_every_second(history_);
  stride_ *= 2;
}

void Session::load(const Scenario& scenario) { begin(scenario, start_world(scenario)); }

void Session::begin(const Scenario& scenario, World world) {
  Checkpoint checkpoint;
  checkpoint.world = std::move(world);
  scenario_ = scenario;
  changes_.clear();
  view = view_of(scenario, view);
  view.window.reset();
  view.follow = false;
  start(scenario_, std::move(checkpoint));
}

void Session::open(const std::filesystem::path& folder) {
  const RunFolder run{folder};
  auto timeline = std::make_unique<Timeline>(run, kMostSamples);
  // Not the state that the run started from, which need not be there any more.
  begin(read_scene({run.scene(), {}, {}}), timeline->first_world());
  timeline_ = std::move(timeline);
}

void Session::go_on() {
  const RunFolder& run = timeline_->folder();
  const double shown = timeline_->moment().time, first = timeline_->moments().front().time;
  if (is_there(run.state())) {
    StateFile state = read_state(run.state());
    if (std::abs(state.checkpoint.world.time - shown) <= shown - first) {
      std::vector<Values> before = rows_before(timeline_->rows(), state.checkpoint.world.step);
      scenario_ = state.scenario;
      changes_.clear();
      start(scenario_, std::move(state.checkpoint));
      history_.insert(history_.begin(), std::make_move_iterator(before.begin()),
                      std::make_move_iterator(before.end()));
      return;
    }
  }
  reset();
}

void Session::require_computing() const {
  if (timeline_)
    throw InputError(timeline_->folder().path.string(),
                     "is shown as it was computed; go_on continues computing from it");
}

void Session::reset() {
  Checkpoint checkpoint;
  checkpoint.world = start_world(scenario_);
  start(scenario_, std::move(checkpoint));
}

// Besides what the user has chosen: units, and words of the legend.
void Session::take_scene_into_view() {
  const View of_scene = view_of(scenario_, view);
  view.physical = of_scene.physical;
  view.method = of_scene.method;
  view.expects_intruder = of_scene.expects_intruder;
  view.names_reaction = of_scene.names_reaction;
  view.names_applied_force = of_scene.names_applied_force;
}

bool Session::set(const std::string& path, const Json& value) {
  require_computing();
  Json json = to_json(scenario_);
  set_value(json, path, value, path);
  Scenario changed = scenario_from_json(json);
  validate(changed);
  Change change{path, scenario_};
  const bool at_once = take_over(path, std::move(changed));
  changes_.push_back(std::move(change));
  if (changes_.size() > kMostChanges) changes_.erase(changes_.begin());
  return at_once;
}

bool Session::undo() {
  require_computing();
  if (changes_.empty()) throw InputError("undo", "has nothing to undo");
  const Change& last = changes_.back();
  const bool at_once = take_over(last.path, last.before);
  changes_.pop_back();
  return at_once;
}

bool Session::take_over(const std::string& path, Scenario changed) {
  const bool of_phases = path.starts_with("phases"), at_once = holds_at_once(path);
  const bool too_late = of_phases && is_too_late(scenario_, changed, protocol());
  const bool phases_fit =
      !by_hand_ && same_kinds(changed.phases, phases(), protocol().state().phase);
  Scenario now = with_parts_that_hold(protocol().scenario(), changed);
  if (!phases_fit) now.phases = phases();
  if (at_once) refuse_shapes_in_nscd(now, protocol(), path);
  scenario_ = std::move(changed);
  take_scene_into_view();
  if (!at_once) return false;
  sampled_run_->protocol().change(now);
  sampled_run_->sample_every(every_);
  failed_ = false;
  return !too_late && (phases_fit || !of_phases);
}

void Session::begin_phase(const Phase& phase) {
  require_computing();
  sampled_run_->protocol().begin_phase(phase);
  by_hand_ = true;
  failed_ = false;
}

void Session::apply(int body, const std::optional<Vec2>& force, std::optional<double> torque) {
  require_computing();
  sampled_run_->protocol().apply(body, force, torque);
}

void Session::sample_every(std::optional<double> every) {
  every_ = every;
  sampled_run_->sample_every(every);
}

void Session::sample() { sampled_run_->sample(); }

RunStop Session::run(const RunUntil& until) {
  require_computing();
  const std::int64_t first_step = world().step;
  const double first_time = world().time;
  const int first_phase = protocol().state().phase;
  std::int64_t last_step = first_step;
  int phase_of_step = first_phase;
  phases_ended_after_steps_ = 0;
  sampled_run_->protocol().clock().meanwhile = meanwhile;
  while (true) {
    if (finished()) return RunStop::finished;
    if (failed_) return RunStop::failed;
    if (until.steps && world().step - first_step >= *until.steps) return RunStop::steps;
    // Times are sums of steps: a moment that is reached within rounding is reached.
    constexpr double kRounding = 1e-9;
    if (until.time && world().time - first_time >= *until.time - kRounding) return RunStop::time;
    if (until.phase_end && protocol().state().phase != first_phase) return RunStop::phase_end;
    if (until.condition && until.condition(*this)) return RunStop::condition;
    if (stop_asked && stop_asked(*this)) return RunStop::cut_short;
    const Progress progress = sampled_run_->advance();
    const int phase = protocol().state().phase;
    if (std::exchange(last_step, world().step) != last_step) phase_of_step = phase;
    phases_ended_after_steps_ = phase - phase_of_step;
    if (progress == Progress::given_up) return RunStop::cut_short;
    failed_ = progress == Progress::failed;
  }
}

void Session::save(const std::filesystem::path& file) const {
  require_computing();
  write_checkpoint(file, {world(), protocol().state(), to_text(protocol().scenario())});
}

void Session::restore(const std::filesystem::path& file) {
  StateFile state = read_state(file);
  scenario_ = state.scenario;
  changes_.clear();
  take_scene_into_view();
  start(scenario_, std::move(state.checkpoint));
}

View Session::shown() const {
  return timeline_ && scales_of_run ? timeline_->with_fixed_scales(view) : view;
}

Row Session::measure_now() const {
  Row row = timeline_ ? Row{} : sampled_run_->last();
  if (!timeline_) row.take_energy(protocol().state());
  row.sample = measure(world());
  row.phase = phase_name();
  return row;
}

std::string Session::newest_critical_force() const {
  if (!loaded() || timeline_ || protocol().state().critical_forces.empty()) return {};
  const CriticalForce& newest = protocol().state().critical_forces.back();
  const std::string unit = newest.kind == SearchKind::vane ? " F_g d" : " F_g";
  // With the usual tolerance of a hundredth, three digits may not tell its ends apart.
  const auto text = [](double force) { return format("%.4g", force); };
  if (!newest.force_high) return "above " + text(newest.force_low) + unit;
  if (newest.force_low == 0) return "below " + text(*newest.force_high) + unit;
  return text(newest.force_low) + " to " + text(*newest.force_high) + unit;
}

}  // namespace quicksand
