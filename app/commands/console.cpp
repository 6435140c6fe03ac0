#include "app/commands/console.h"

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <utility>

#include "app/commands/command_table.h"
#include "app/commands/session_file.h"
#include "app/run_folder/run_folder.h"
#include "app/scene/scene_file.h"
#include "core/base/errors.h"
#include "core/base/memory.h"

namespace quicksand {

namespace fs = std::filesystem;

namespace {

// Files are beside another folder as long as it lives.
class BaseMeanwhile {
 public:
  BaseMeanwhile(std::optional<fs::path>& base, std::optional<fs::path> meanwhile)
      : base_(base), before_(std::exchange(base, std::move(meanwhile))) {}
  ~BaseMeanwhile() { base_ = std::move(before_); }
  BaseMeanwhile(const BaseMeanwhile&) = delete;
  BaseMeanwhile& operator=(const BaseMeanwhile&) = delete;

 private:
  std::optional<fs::path>& base_;
  std::optional<fs::path> before_;
};

}  // namespace

Console::Console(ConsoleFolders folders, double scale)
    : folders_(std::move(folders)), scale_(scale) {
  session_.on_sample = [this](const Row& row, const World&) {
    if (recording) recording->add(row);
  };
}

Json Console::perform(const Json& command, const std::string& place) {
  const SessionCommand& row = command_of(command, place);
  row.check(command, place);
  if (row.needs_scene && !session_.loaded())
    throw CommandFailure("\"" + std::string(row.name) +
                         R"(" needs a scene; load one first: {"command": "load", "scene": ...})");
  return row.perform(*this, command, place);
}

Json Console::perform_beside(const fs::path& base, const Json& command, const std::string& place) {
  const BaseMeanwhile meanwhile(folders_.base, fs::absolute(base));
  return perform(command, place);
}

fs::path Console::output(const std::string& name, const std::string& place) const {
  const fs::path relative = fs::path(name).lexically_normal();
  if (name.empty() || relative.is_absolute() || relative.begin()->string() == ".." ||
      relative.filename().empty() || relative == ".") {
    throw InputError(place, "\"" + name +
                                "\" must name a file in the output folder: no absolute path, none "
                                "that leads out of it");
  }
  fs::path path = folders_.out / relative;
  if (!all_lead_into(folders_.out, path))
    throw InputError(place, "\"" + name + "\" leads out of the output folder through a link");
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) throw InputError(path.parent_path().string(), "cannot be created: " + error.message());
  return path;
}

Json Console::finish_recording() {
  if (!recording) return {};
  if (!session_.timeline()) session_.sample();
  // One that cannot be finished is over all the same: its files stay as they are, and another can begin.
  const std::unique_ptr<Recording> ending = std::move(recording);
  return ending->finish();
}

std::string Console::save_cut_short() {
  std::string told;
  const auto try_to = [&told](auto what) {
    try {
      what();
    } catch (const InputError& error) {
      told += "; " + error.where() + ": " + error.what();
    } catch (const std::exception& error) {
      told += std::string("; ") + error.what();
    }
  };
  try_to([&] { finish_recording(); });
  // What is shown is in its folder.
  if (!session_.loaded() || session_.timeline()) return told;
  try_to([&] {
    const fs::path state = folders_.out / "interrupted.cbor";
    session_.save(state);
    told += "; the state is in " + state.string();
  });
  return told;
}

fs::path Console::input(const std::string& name) const {
  if (!folders_.base) return beside(name);
  std::error_code ignored;
  const fs::path ours = folders_.out / name;
  return fs::path(name).is_relative() && fs::exists(ours, ignored) ? ours : beside(name);
}

// An absolute name stays what it is.
fs::path Console::beside(const std::string& name) const {
  fs::path path = folders_.base.value_or(folders_.out) / name;
  if (!folders_.base && !leads_into(folders_.out, path))
    throw InputError(name, "lies outside the output folder, where a browser can reach no file");
  return path;
}

fs::path Console::scene(const std::string& name) const {
  const fs::path folder = folders_.base.value_or(folders_.out);
  if (!folders_.base) beside(name);
  return scene_named(name, folder);
}

Image Console::draw_view(int width, int height) {
  if (!renderer_) renderer_ = std::make_unique<Renderer>();
  View view = session_.shown();
  view.width = width;
  view.height = height;
  const auto caption =
      std::to_array<std::string>({session_.scenario().name, session_.phase_name()});
  return renderer_->draw(session_.world(), view, caption);
}

Gui& Console::panel() {
  if (!panel_) panel_ = std::make_unique<Gui>(scale_);
  return *panel_;
}

UiDriver& Console::ui_driver() {
  if (!ui_driver_)
    ui_driver_ = std::make_unique<UiDriver>(
        panel(), session_, session_.view.width, session_.view.height,
        [this](const std::vector<Json>& commands) { carry_out(commands); });
  ui_driver_->resize(session_.view.width, session_.view.height);
  return *ui_driver_;
}

void Console::carry_out(const Json& command) {
  perform(command, "panel");
  if (given) given(command);
}

void Console::carry_out(const std::vector<Json>& commands) {
  std::vector<Json> all = std::exchange(waiting_, {});
  all.insert(all.end(), commands.begin(), commands.end());
  for (const Json& command : all) carry_out(command);
  panel().set_recording(recording != nullptr);
  if (Timeline* timeline = session_.timeline(); timeline && timeline->playing)
    timeline->play_frame();
  if (!session_.running || !session_.loaded()) return;
  const std::int64_t first = session_.world().step;
  RunUntil frame;
  frame.steps = session_.steps_per_frame;
  const auto tell = [&] {
    if (computed) computed(session_.world().step - first);
  };
  try {
    session_.run(frame);
  } catch (...) {  // a phase that is refused, or a recording that finds no room
    session_.running = false;
    tell();
    throw;
  }
  tell();
  if (session_.finished() || session_.failed()) session_.running = false;
  if (session_.failed())
    throw CommandFailure("the simulation stopped: " + session_.protocol().failure());
}

template <class Do>
void Console::tell_failure(Do what) {
  try {
    what();
  } catch (const InputError& error) {
    panel().show_refusal(error);
  } catch (const CommandFailure& error) {
    panel().show_error(error.what());
  } catch (const NotEnoughMemory& error) {
    panel().show_error(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    panel().show_error(error.what());
  }
}

Image Console::panel_frame(const GuiInput& input, int width, int height) {
  const std::vector<Json> commands = panel().frame(session_, input, width, height);
  Image picture = panel().paint();
  tell_failure([&] { carry_out(commands); });
  return picture;
}

Image Console::look(const GuiInput& input, int width, int height) {
  for (Json& command : panel().frame(session_, input, width, height)) {
    if (only_looks(command))
      tell_failure([&] { carry_out(command); });
    else
      waiting_.push_back(std::move(command));
  }
  return panel().paint();
}

bool Console::step_is_given_up() const { return std::ranges::any_of(waiting_, cuts_short); }

Image Console::draw_panel(int width, int height, std::optional<double> scale) {
  constexpr int kSettling = 3;  // frames until the layout of a new size rests
  const auto picture_of = [&](Gui& gui, const GuiInput& input) {
    const bool rests = recording && gui.width() == width && gui.height() == height;
    for (int i = rests ? kSettling - 1 : 0; i < kSettling; ++i)
      gui.frame(session_, input, width, height);
    return gui.paint();
  };
  if (scale && *scale != panel().scale()) {
    // Another scale is another panel; the present one keeps what it shows.
    Gui other(*scale);
    return picture_of(other, {});
  }
  GuiInput still;
  still.mouse = ui_driver().mouse();
  return picture_of(panel(), still);
}

void Console::include(const fs::path& file, const std::string& place) {
  constexpr int kDeepest = 10;
  if (depth_ >= kDeepest)
    throw InputError(place, "files include each other more than " + std::to_string(kDeepest) +
                                " deep; does one include itself?");
  const SessionFile included = read_session_file(file);
  // Whoever is not trusted is not so through a file, either.
  std::optional<fs::path> base;
  if (folders_.base) base = fs::absolute(file).parent_path();
  const BaseMeanwhile meanwhile(folders_.base, std::move(base));
  ++depth_;
  const auto leave = [&] { --depth_; };
  try {
    for (std::size_t i = 0; i < included.commands.size() && !quit && !session_.is_to_end(); ++i) {
      const Json& command = included.commands[i];
      const std::string told = "\n  the command: " + command.dump();
      try {
        perform(command, place_of(i));
      } catch (const InputError& error) {
        throw CommandFailure(included.where(i) + ": " + error.where() + ": " + error.what() + told);
      } catch (const CommandFailure& error) {
        // What failed in a file within this one is told already.
        const bool is_told = command["command"] == "include";
        throw CommandFailure(included.where(i) + ": " + error.what() + (is_told ? "" : told));
      }
    }
  } catch (...) {
    leave();
    throw;
  }
  leave();
}

}  // namespace quicksand
