// What can be done to the packing by hand, and files of its state.
#include <imgui.h>

#include "app/panel/panel_frame.h"

namespace quicksand::gui {
namespace {

constexpr double kLongest = 20;  // of a phase that is begun by hand [sqrt(d/g)]

// A button, and beside it the force that it uses. Returns whether it was pressed.
bool act(PanelFrame& frame, const Widgets::Label& action, const Widgets::Label& entry,
         double& force) {
  Widgets& w = frame.widgets;
  const float width = w.label_width() - ImGui::GetStyle().ItemSpacing.x;
  const bool pressed = w.button(action, width);
  ImGui::SameLine();
  if (const auto given = w.number(entry, force, false)) force = *given;
  return pressed;
}

}  // namespace

void show_actions(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  PanelEntries& entries = frame.entries;
  if (!w.begin_section("Actions", false)) return;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float half = (ImGui::GetContentRegionAvail().x - gap) / 2;

  if (act(frame, {"Push", {}, "Puts an intruder on the surface and pushes it down."},
          {"push force", {}, "Downward, in addition to the intruder's weight.", "F_g", true},
          entries.push_force)) {
    frame.command(
        "push",
        {{"diameter", 3}, {"density", 0.5}, {"force", entries.push_force}, {"max_time", kLongest}});
  }
  const bool intruder = frame.session.loaded() && frame.session.world().intruder() >= 0;
  {
    const Widgets::Disabled disabled(w, !intruder);
    if (act(frame,
            {"Pull",
             {},
             std::string("Finds the smallest force that pulls the intruder out.") +
                 (intruder ? "" : " There is none.")},
            {"pull force", {}, "Upward, in the first trial.", "F_g", true}, entries.pull_force)) {
      frame.command("pull", {{"first_force", entries.pull_force}});
    }
  }
  if (act(frame,
          {"Piston",
           {},
           "Places a piston on the packing, or takes the one that stands, presses it down and "
           "removes it."},
          {"piston force", {}, "Downward, in addition to the piston's weight.", "F_g", true},
          entries.piston_force)) {
    frame.command("piston", {{"mass", 1}, {"force", entries.piston_force}, {"max_time", kLongest}});
  }
  if (w.button({"Heal", {}, "Restores the bonds of all contacts."}, w.label_width() - gap)) {
    frame.command("heal");
  }

  ImGui::Dummy(ImVec2(0, w.px(2)));
  if (const auto file = w.text({"file", "State file", "Where the state is saved."}, entries.file)) {
    entries.file = *file;
  }
  if (w.button({"Save state", {}, "Saves everything needed to continue."}, half)) {
    frame.command("save", {{"file", entries.file}});
  }
  ImGui::SameLine();
  if (w.button({"Load state", {}, "Continues from a saved state."}, half)) {
    frame.command("restore", {{"file", entries.file}});
  }
  if (const auto on = w.checkbox({"Record frames", {}, "Writes each frame to a picture file."},
                                 frame.notes.recording)) {
    frame.command("record", {{"on", *on}});
  }
  w.end_section();
}

}  // namespace quicksand::gui
