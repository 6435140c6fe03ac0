// What the parts of the panel share during a frame, and the parts: each a function that draws its
// widgets and adds the commands that they give.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/json/json_text.h"
#include "app/session/session.h"
#include "app/widgets/view_picture.h"
#include "app/widgets/widgets.h"

namespace quicksand::gui {

// What the user has put into fields that are not values of the session.
struct PanelEntries {
  double push_force = 1e4;    // [F_g]
  double pull_force = 10;     // first trial [F_g]
  double piston_force = 1e3;  // [F_g]
  std::string file = "state.cbor";
  std::filesystem::path folder;          // whose files can be opened; the present one if empty
  std::vector<std::string> files;        // of the list that is open
  std::optional<double> drag_stiffness;  // force over distance [F_g/d]; from the scene if absent
};

// The mouse in the view: a grain that is being dragged, or the picture.
struct Grip {
  int body = -1;
  Vec2 start{0, 0};    // where the button went down [px]
  bool pulls = false;  // moved far enough to be more than a click
  bool moves = false;  // the same beside the grains: the picture goes along
  Vec2 last{0, 0};     // where the mouse was when the picture moved last [px]
  Vec2 force{0, 0};    // last commanded [F_g]
};

// What the panel knows besides the session.
struct PanelNotes {
  std::string error;  // shown until dismissed
  std::string refused_path,
      refusal;       // of it the place of a value and what is wrong, if it is of one
  std::string hint;  // shown over the picture until the first command
  std::optional<double> steps_per_second, eta_seconds;
  bool recording = false;
  std::vector<std::string> recent;  // what was opened before, the last first
  std::optional<int> inspected;     // body that the last frame showed
};

struct PanelFrame {
  Widgets& widgets;
  const Session& session;
  PanelEntries& entries;
  PanelNotes& notes;
  std::vector<Json>& commands;

  // What went wrong before no longer matters to who tries something else.
  void command(const char* name, const Json& arguments = Json::object()) {
    notes.error.clear();
    Json json{{"command", name}};
    json.update(arguments);
    commands.push_back(std::move(json));
  }
};

void show_scene(PanelFrame& frame);
void show_controls(PanelFrame& frame);
// Of a run that is shown: its controls, and the strip of its samples, phases and failing bonds.
void show_timeline(PanelFrame& frame);
void show_timeline_strip(PanelFrame& frame, const PixelRect& rect);
void show_parameters(PanelFrame& frame);
void show_actions(PanelFrame& frame);
void show_view_controls(PanelFrame& frame);
void show_plots(PanelFrame& frame);
void show_inspection(PanelFrame& frame);
void show_status(PanelFrame& frame);
void show_banner(PanelFrame& frame);
// The mouse upon the picture of the packing, and what is drawn over it, in the present window.
void show_view(PanelFrame& frame, ViewPicture& picture, Grip& grip, const PixelRect& rect);

// Force over distance of a grain that is dragged [F_g/d].
double drag_stiffness(const PanelFrame& frame);

}  // namespace quicksand::gui
