// What can be done to the packing by hand, and files of its state.
#include <imgui.h>

#include "app/gui/panel_frame.h"

namespace quicksand::gui {
namespace {

constexpr double kLongest = 20;  // of a phase that is begun by hand [sqrt(d/g)]

// A number of the panel's own.
void entry(PanelFrame& frame, const Widgets::Label& label, double& value) {
  if (const auto given = frame.widgets.number(label, value, false)) value = *given;
}

}  // namespace

void show_actions(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  PanelEntries& entries = frame.entries;
  if (!w.begin_section("Actions", false)) return;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x;
  const float half = (room - gap) / 2;

  const bool intruder = frame.session.loaded() && frame.session.world().intruder() >= 0;
  entry(frame,
        {"push force", "Push with", "Downward force on the intruder, besides its weight.", "F_g"},
        entries.push_force);
  entry(frame, {"pull force", "Pull from", "Upward force of the first trial.", "F_g"},
        entries.pull_force);
  entry(frame,
        {"piston force", "Piston with", "Downward force, besides the piston's weight.", "F_g"},
        entries.piston_force);
  if (w.button({"Push", {}, "Puts an intruder on the surface and pushes it down."}, half)) {
    frame.command(
        "push",
        {{"diameter", 3}, {"density", 0.5}, {"force", entries.push_force}, {"max_time", kLongest}});
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(!intruder);
  if (w.button({"Pull",
                {},
                intruder ? "Seeks the smallest force that takes the intruder out."
                         : "Seeks the smallest force that takes the intruder out. There is none."},
               half)) {
    frame.command("pull", {{"first_force", entries.pull_force}});
  }
  ImGui::EndDisabled();
  if (w.button({"Piston", {}, "Lays a piston on the packing and presses it down."}, half)) {
    frame.command("piston", {{"mass", 1}, {"force", entries.piston_force}, {"max_time", kLongest}});
  }
  ImGui::SameLine();
  if (w.button({"Heal", {}, "Restores the bonds of all contacts."}, half)) frame.command("heal");

  ImGui::Dummy(ImVec2(0, w.px(2)));
  if (const auto file = w.text({"file", "State file", "Where the state is saved."}, entries.file)) {
    entries.file = *file;
  }
  if (w.button({"Save state", {}, "Saves all that is needed to go on."}, half)) {
    frame.command("save", {{"file", entries.file}});
  }
  ImGui::SameLine();
  if (w.button({"Load state", {}, "Goes on from a saved state."}, half)) {
    frame.command("restore", {{"file", entries.file}});
  }
  if (const auto on = w.checkbox({"Record frames", {}, "Writes each frame to a picture file."},
                                 frame.notes.recording)) {
    frame.command("record", {{"on", *on}});
  }
  w.end_section();
}

}  // namespace quicksand::gui
