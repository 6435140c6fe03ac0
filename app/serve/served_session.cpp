#include "app/serve/served_session.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <new>
#include <utility>

#include "app/commands/command_table.h"
#include "app/commands/transcript.h"
#include "app/series/series.h"
#include "app/serve/binary_message.h"
#include "app/serve/frame_message.h"
#include "app/serve/page_state.h"
#include "app/session/disk_at.h"
#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/base/whole_file.h"
#include "render/base/render_error.h"
#include "render/image/png.h"

namespace quicksand {

namespace {

using namespace std::chrono_literals;

constexpr auto kIdle = 100ms;
constexpr auto kFramePeriod = 16ms;  // of a session that runs: as long as a screen shows a picture
constexpr auto kPicturePeriod = 30ms;  // between two pictures while it computes
constexpr auto kPlotsPeriod = 500ms;
constexpr auto kLookPeriod = 500ms;  // for new samples of a run that another process computes
constexpr const char* kRecordingFile = "recording.json";
constexpr const char* kSeriesFile = "series.csv";

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string_view name_of(const Json& command) {
  return command["command"].get_ref<const std::string&>();
}

// After which the controls of the page may look otherwise.
bool changes_controls(const Json& command) {
  constexpr auto kNames =
      std::to_array<std::string_view>({"apply", "camera", "pick", "measure", "show", "play"});
  return std::ranges::find(kNames, name_of(command)) == kNames.end();
}

}  // namespace

ServedSession::ServedSession(const ServedOptions& options, Exchange& exchange)
    : options_(options), exchange_(exchange), console_({options.folder, std::nullopt}) {
  console_.session().stop_asked = [this](const Session& session) { return listen(session); };
  console_.session().meanwhile = [this] {
    look_up();
    return run_is_to_end();
  };
  console_.print = [this](const std::string& text) {
    tell(kEveryClient, {{"kind", "note"}, {"text", text}}, nullptr);
  };
}

void ServedSession::begin(const Json& command) {
  console_.perform_beside(std::filesystem::current_path(), command, "command line");
  interactions_.add(command);
}

std::string ServedSession::recording() const {
  const Session& session = console_.session();
  const Timeline* timeline = session.timeline();
  return interactions_.session(session.world(),
                               timeline ? std::optional(timeline->shown()) : std::nullopt);
}

bool ServedSession::plays() const {
  const Timeline* timeline = console_.session().timeline();
  return timeline != nullptr && timeline->playing;
}

void ServedSession::take_turn() {
  const bool runs = console_.session().running || plays();
  const bool something = !waiting_.empty();
  take_messages(runs || something ? 0ms : kIdle);
  while (!waiting_.empty()) answer_next();
  look_for_samples();
  publish_frame();
  if (console_.session().running) compute();
  if (plays()) play();
  publish_frame();
  publish_slow_parts();
}

// After each step: what can be answered at once is, and what cannot ends the computing.
bool ServedSession::listen(const Session& session) {
  plots_are_old_ = picture_is_old_ = true;
  look_up();
  return run_is_to_end() || (session.running && !waiting_.empty());
}

bool ServedSession::run_is_to_end() const {
  return (interrupted && interrupted()) || std::ranges::any_of(waiting_, &Waiting::ends_run);
}

// Also within a step, which may take long.
void ServedSession::look_up() {
  if (exchange_.something_waits()) take_messages(0ms);
  bool seen_otherwise = false;
  for (; !waiting_.empty() && waiting_.front().looks; seen_otherwise = true) answer_next();
  if (seen_otherwise || Clock::now() - last_frame_ >= kPicturePeriod) publish_frame();
}

void ServedSession::take_messages(std::chrono::milliseconds wait) {
  for (const ClientText& message : exchange_.take(wait, picture_is_old_)) hear(message);
  for (const ClientId gone : exchange_.take_gone())
    std::erase_if(waiting_, [gone](const Waiting& waiting) { return waiting.said.client == gone; });
}

void ServedSession::hear(const ClientText& text) {
  Json id;
  try {
    const ClientMessage message = read_message(text.text, id);
    // Of the world as it is. A recording or a series waits until the steps under way are among those that are counted.
    if (message.command.is_null() && message.question["ask"] == "body")
      return tell(text.client, {{"ok", true}, {"result", answer_question(message.question)}}, id);
    if (!has_room(waiting_, text, &Waiting::said))
      throw InputError(
          "message",
          "arrived while too many commands of this page were waiting; pause, or try again");
    const bool is_command = !message.command.is_null();
    waiting_.push_back({text, is_command && only_looks(message.command),
                        is_command && cuts_short(message.command)});
  } catch (const InputError& error) {
    tell_problem(text.client, error, id);
  }
}

void ServedSession::answer_next() {
  const ClientText next = std::move(waiting_.front().said);
  waiting_.pop_front();
  Json id;
  try {
    const ClientMessage message = read_message(next.text, id);
    if (!message.command.is_null()) return perform(next.client, message.command, id);
    tell(next.client, {{"ok", true}, {"result", answer_question(message.question)}}, id);
  } catch (const InputError& error) {
    tell_problem(next.client, error, id);
  }
}

void ServedSession::perform(ClientId client, const Json& command, const Json& id) {
  const bool loaded = console_.session().loaded();
  const std::int64_t first = loaded ? console_.session().world().step : 0;
  const bool followed = console_.session().view.follow;
  console_.session().take_phases_ended_after_steps();  // of an earlier run
  const Answer answer = answer_to(console_, command, "command");
  if (answer.ok) record(command, answer.result);
  theme_chosen_ = theme_chosen_ || command.contains("theme");
  if (!answer.ok && name_of(command) == "run" && loaded)
    interactions_.add_steps(console_.session().world().step - first,
                            console_.session().take_phases_ended_after_steps());
  tell_if_full();
  picture_is_old_ = true;
  if (changes_controls(command)) state_is_old_ = plots_are_old_ = true;
  if (console_.session().view.follow != followed) state_is_old_ = true;
  Json json = to_json(answer, console_);
  json["command"] = command;
  tell(client, std::move(json), id);
}

// A run that was cut short replays as the steps that it made.
void ServedSession::record(const Json& command, const Json& result) {
  if (result.value("ended_by", "") == word_of(RunStop::cut_short)) {
    interactions_.add_steps(result["steps"].get<std::int64_t>(),
                            console_.session().take_phases_ended_after_steps());
  } else {
    interactions_.add(command);
  }
}

void ServedSession::tell_if_full() {
  if (!interactions_.full() || std::exchange(told_full_, true)) return;
  const std::string text =
      "the recording is full: further actions are not recorded; download it, and restart "
      "`quicksand serve` to record more";
  std::fprintf(stderr, "quicksand: %s\n", text.c_str());
  tell(kEveryClient, {{"ok", false}, {"error", text}}, nullptr);
}

template <class Do>
bool ServedSession::succeeds(Do what) {
  std::string problem;
  try {
    what();
    return true;
  } catch (const InputError& error) {
    problem = (error.where().empty() ? "" : error.where() + ": ") + error.what();
  } catch (const RenderError& error) {
    problem = error.what();
  } catch (const NotEnoughMemory& error) {
    problem = error.what();
  } catch (const std::bad_alloc&) {
    problem = "there is not enough memory for this";
  }
  tell(kEveryClient, {{"ok", false}, {"error", problem}}, nullptr);
  return false;
}

// One frame of a session that runs: so many steps, and at least as long as a picture stands.
void ServedSession::compute() {
  Session& session = console_.session();
  const auto began = Clock::now();
  const std::int64_t first = session.world().step;
  RunUntil frame;
  frame.steps = session.steps_per_frame;
  RunStop stop = RunStop::failed;
  // A phase that is refused, or a recording that finds no room.
  if (!succeeds([&] { stop = session.run(frame); })) {
    session.running = false;
    state_is_old_ = true;
  }
  const std::int64_t steps = session.world().step - first;
  interactions_.add_steps(steps, session.take_phases_ended_after_steps());
  tell_if_full();
  rate_.add(steps, session.protocol());
  if (session.finished() || session.failed()) {
    session.running = false;
    state_is_old_ = true;
  }
  if (session.failed())
    tell(kEveryClient,
         {{"ok", false}, {"error", "the simulation stopped: " + session.protocol().failure()}},
         nullptr);
  picture_is_old_ = plots_are_old_ = true;
  if (stop != RunStop::steps) return;
  publish_frame();
  // The wait for messages is the rest of the frame.
  const auto left = kFramePeriod - (Clock::now() - began);
  if (left > 0ms) take_messages(std::chrono::duration_cast<std::chrono::milliseconds>(left));
}

// One frame of a run that is walked through.
void ServedSession::play() {
  const auto began = Clock::now();
  Timeline& timeline = *console_.session().timeline();
  if (!succeeds([&] { timeline.play_frame(); })) timeline.playing = false;
  picture_is_old_ = true;
  publish_frame();
  const auto left = kFramePeriod - (Clock::now() - began);
  if (left > 0ms) take_messages(std::chrono::duration_cast<std::chrono::milliseconds>(left));
}

// The run that is shown may still be computing.
void ServedSession::look_for_samples() {
  Timeline* timeline = console_.session().timeline();
  if (timeline == nullptr || Clock::now() - looked_ < kLookPeriod) return;
  looked_ = Clock::now();
  succeeds([&] {
    if (timeline->refresh()) picture_is_old_ = plots_are_old_ = true;
  });
}

Json ServedSession::answer_question(const Json& question) {
  const std::string& name = question["ask"].get_ref<const std::string&>();
  const Session& session = console_.session();
  if (!session.loaded()) throw InputError("ask", "there is no scene");
  if (name == "body") {
    const Json at = question.value("at", Json());
    if (!at.is_array() || at.size() != 2 || !at[0].is_number() || !at[1].is_number())
      throw InputError("at", "must be a place [x, y]");
    const int body = disk_at(session.world(), {at[0].get<double>(), at[1].get<double>()});
    return body < 0 ? Json{{"body", nullptr}} : body_state(session, body);
  }
  if (name == "recording") {
    write_whole(console_.output(kRecordingFile, "ask"), recording());
    return {{"file", kRecordingFile}};
  }
  if (name == "series") {
    Series series(console_.output(kSeriesFile, "ask"));
    for (const Values& row : session.history()) series.add(row);
    return {{"file", kSeriesFile}};
  }
  throw InputError("ask", "must be body, recording or series");
}

Json ServedSession::moment() const {
  const Session& session = console_.session();
  const World& world = session.world();
  const Protocol& protocol = session.protocol();
  Json head{{"kind", "frame"},
            {"step", world.step},
            {"time", world.time},
            {"bodies", world.disks.size()},
            {"scene", session.scenario().name},
            {"phase", protocol.state().phase},
            {"phase_name", session.phase_name()},
            {"progress", session.finished() ? 1 : protocol.phase_progress()},
            {"running", session.running},
            {"finished", session.finished()},
            {"failed", session.failed()},
            {"recording", console_.recording != nullptr},
            {"follows", session.view.follow},
            {"picked", session.picked ? Json(*session.picked) : Json()},
            {"pull", session.scenario().grain_law.cohesion_force.value_or(10)}};
  if (const Timeline* timeline = session.timeline()) {
    head["phase"] = timeline->moment().phase;
    head["timeline"] = {{"sample", timeline->shown()},
                        {"samples", timeline->moments().size()},
                        {"playing", timeline->playing},
                        {"speed", timeline->speed},
                        {"loop", timeline->loop}};
    return head;
  }
  if (rate_.per_second()) head["steps_per_second"] = *rate_.per_second();
  if (rate_.left()) head["seconds_left"] = *rate_.left();
  if (protocol.last_step().seconds > 0)
    head["residual"] = protocol.last_step().solve.residual.natural;
  head["unconverged"] = protocol.state().unconverged_steps;
  if (const std::string found = session.newest_critical_force(); !found.empty())
    head["critical_force"] = found;
  return head;
}

// The frame as pixels.
std::string ServedSession::picture() {
  const Session& session = console_.session();
  const Image image = console_.draw_view(session.view.width, session.view.height);
  Json head = moment();
  head.update(look_of(session));
  BinaryMessage binary;
  binary.add("png", std::span<const std::uint8_t>(encode_png(image)));
  return binary.finish(std::move(head));
}

void ServedSession::publish_frame() {
  if (!console_.session().loaded() || !picture_is_old_ || !exchange_.frame_wanted()) return;
  const Session& session = console_.session();
  std::string message;
  // Of a run that is walked through, a record may be damaged.
  succeeds([&] { message = options_.pixels ? picture() : frame_message(session, moment()); });
  picture_is_old_ = false;
  last_frame_ = Clock::now();
  if (!message.empty()) exchange_.publish(Newest::frame, std::move(message));
}

Json ServedSession::state() const {
  Json state = page_state(console_.session());
  state["theme_chosen"] = theme_chosen_;
  return state;
}

void ServedSession::publish_slow_parts() {
  const Session& session = console_.session();
  if (state_is_old_) exchange_.publish(Newest::state, text_of(state()));
  state_is_old_ = false;
  if (!session.loaded() || !plots_are_old_ || Clock::now() - last_plots_ < kPlotsPeriod) return;
  exchange_.publish(Newest::plots, plots_message(session));
  plots_are_old_ = false;
  last_plots_ = Clock::now();
}

void ServedSession::tell_problem(ClientId client, const InputError& error, const Json& id) {
  tell(client, {{"ok", false}, {"where", error.where()}, {"error", error.what()}}, id);
}

void ServedSession::tell(ClientId client, Json answer, const Json& id) {
  if (!id.is_null()) answer["id"] = id;
  exchange_.answer(client, text_of(answer));
}

}  // namespace quicksand
