// The panel of the program beside the view of the packing, drawn offscreen.
//
// It holds no physics: it shows a session and returns what the user asks for as commands, the same
// that a command file is written in. ImGui stays behind this file.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/gui/gui_input.h"
#include "app/json/json_text.h"
#include "app/session/session.h"
#include "app/widgets/widget.h"
#include "core/base/errors.h"
#include "render/base/camera.h"
#include "render/image/image.h"

namespace quicksand {

class Gui {
 public:
  // `scale`: pixels of the picture over those of the design, from 0.5 to 4. Throws RenderError if there
  // is no font, InputError for other scales.
  explicit Gui(double scale = 1);
  ~Gui();

  // One frame of the panel: shows the session, takes the input. Returns the commands that the user gave
  // by it, as JSON objects {"command": NAME, ...}. Needs no GL. Throws InputError for a size [px] that
  // cannot be drawn.
  std::vector<Json> frame(const Session& session, const GuiInput& input, int width, int height);
  // The picture of the last frame. The session must not have changed since. Throws RenderError.
  Image paint();

  // Of the last frame.
  std::span<const Widget> widgets() const;
  // The widget that the mouse is on; null if there is none, or it is disabled.
  const Widget* hovered() const;
  // Whether what is typed goes into a field.
  bool takes_text() const;
  int width() const;
  int height() const;
  double scale() const;
  // From places of the world to pixels of the whole picture. None before a scene is loaded.
  std::optional<Camera> view_camera() const;

  // A banner that stays until the user dismisses it.
  void show_error(std::string message);
  // The same of a value that was refused, which is also told beside its control.
  void show_refusal(const InputError& error);
  // What to press, over the picture until the panel gives its first command.
  void show_hint(std::string text);
  // For the status line; what is not known is not shown.
  void set_rate(std::optional<double> steps_per_second, std::optional<double> eta_seconds);
  // Whether frames are recorded.
  void set_recording(bool on);
  // Paths that can be opened again, the last first.
  void set_recent(std::vector<std::string> paths);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quicksand
