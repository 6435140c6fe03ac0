// What commands act on: a session, the folder that receives its files, pictures of it, and the panel.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/gui/gui.h"
#include "app/gui/ui_driver.h"
#include "app/session/recording.h"
#include "app/session/session.h"
#include "render/picture/renderer.h"

namespace quicksand {

struct ConsoleFolders {
  std::filesystem::path out;  // receives every file that commands write; made when needed
  // Of the command file, beside which others are read. Without one, commands come from somebody who is not trusted:
  // they read shipped scenes and what is in the folder above.
  std::optional<std::filesystem::path> base;
};

class Console {
 public:
  // `scale`: of the panel's letters and controls.
  explicit Console(ConsoleFolders folders, double scale = 1);

  // Performs one command {"command": NAME, ...}; `place` names it in errors. Returns what it has to
  // tell. Throws InputError, CommandFailure, RenderError; then nothing but what it began has changed.
  Json perform(const Json& command, const std::string& place = {});
  // The same for a command of the user, who may name files beside this folder.
  Json perform_beside(const std::filesystem::path& base, const Json& command,
                      const std::string& place);

  Session& session() { return session_; }
  const Session& session() const { return session_; }

  // A file that a command writes: inside the folder for output, whatever the name says. Makes its
  // folder. Throws InputError for absolute names and those that lead out of it, also by a link.
  std::filesystem::path output(const std::string& name, const std::string& place) const;
  // Ends the recording, if there is one, with the present moment as its last sample; what it has made.
  Json finish_recording();
  // Ends what a session that is cut short was recording, and saves its state under a name that no command gives by
  // itself. What to tell of it: "; the state is in out/x/interrupted.cbor", or what went wrong; empty where nothing is
  // computed.
  std::string save_cut_short();
  // A file that this session wrote, or one beside the command file.
  std::filesystem::path input(const std::string& name) const;
  // A file beside the command file; without one, in the folder for output. Throws InputError for one beyond that.
  std::filesystem::path beside(const std::string& name) const;
  // A scene beside the command file, or a shipped one by its name. Throws as above.
  std::filesystem::path scene(const std::string& name) const;

  // The panel, made when it is first asked for. Throws RenderError if there is no font.
  Gui& panel();
  // Acts on the panel; what it commands is performed, and each frame computes if the session runs.
  UiDriver& ui_driver();
  // One frame of the panel in a window, and its picture: as above, but what fails shows in a banner of
  // the panel. Throws RenderError.
  Image panel_frame(const GuiInput& input, int width, int height);
  // The same while a step is under way, from Session::meanwhile: what only looks is done, and other commands wait for
  // the next frame.
  Image look(const GuiInput& input, int width, int height);
  bool commands_wait() const { return !waiting_.empty(); }
  // Whether one of these does not wait for the step's end, either.
  bool step_is_given_up() const;
  // Told of each command that a panel gave and that succeeded, and of the steps that its frames computed.
  std::function<void(const Json&)> given;
  std::function<void(std::int64_t)> computed;

  // Pictures of the present moment. Throw RenderError if this system cannot draw.
  Image draw_view(int width, int height);
  Image draw_panel(int width, int height, std::optional<double> scale);

  std::unique_ptr<Recording> recording;
  bool quit = false;
  // Performs the commands of another file; those paths are relative to it. Throws InputError where files
  // include each other too deep.
  void include(const std::filesystem::path& file, const std::string& place);
  // Receives the texts of `print`. May be empty.
  std::function<void(const std::string&)> print;

 private:
  ConsoleFolders folders_;
  Session session_;
  void carry_out(const std::vector<Json>& commands);
  void carry_out(const Json& command);
  // Tells in the panel what fails.
  template <class Do>
  void tell_failure(Do what);

  std::vector<Json> waiting_;  // commands that came within a step

  std::unique_ptr<Renderer> renderer_;
  double scale_;
  std::unique_ptr<Gui> panel_;
  std::unique_ptr<UiDriver> ui_driver_;
  int depth_ = 0;  // of included files
};

}  // namespace quicksand
