// How the packing is drawn, and from where.
#include <imgui.h>

#include "app/panel/panel_frame.h"
#include "app/view/view_fields.h"

namespace quicksand::gui {
namespace {

constexpr double kZoom = 1.25;  // of a press on + or -

void show_camera(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float small = w.px(32);
  const float wide = (ImGui::GetContentRegionAvail().x - 2 * small - 3 * gap) / 2;
  if (w.button({"Fit box", {}, "Shows the whole box."}, wide)) {
    frame.command("camera", {{"fit", "box"}});
  }
  ImGui::SameLine();
  if (w.button({"Fit bodies", {}, "Shows all bodies."}, wide)) {
    frame.command("camera", {{"fit", "content"}});
  }
  ImGui::SameLine();
  if (w.button({"Zoom in", "+", "Closer. Also by the wheel, over the picture."}, small)) {
    frame.command("camera", {{"zoom", kZoom}});
  }
  ImGui::SameLine();
  if (w.button({"Zoom out", "−", "Farther away."}, small)) {
    frame.command("camera", {{"zoom", 1 / kZoom}});
  }
}

// Those that what is drawn depends on.
void show_numbers(PanelFrame& frame) {
  const View& view = frame.session.view;
  for (const ViewNumber& number : view_numbers()) {
    if (!number.matters(view)) continue;
    const ViewField& field = number.field;
    if (const auto value = frame.widgets.number(
            {field.name, field.label, capitalised(field.help) + "."}, view.*number.value, false))
      frame.command("view", {{field.name, *value}});
  }
}

}  // namespace

void show_view_controls(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  const View& view = frame.session.view;
  if (!w.begin_section("View", true)) return;
  for (const ViewWord& word : view_words()) {
    const bool colours = std::string_view(word.field.name) == "colour";
    std::vector<std::string> helps;
    for (const ColouringInfo& colouring : colourings())
      if (colours) helps.emplace_back(colouring.description);
    const std::vector<std::string> names(word.words.begin(), word.words.end());
    if (const auto name = w.combo({word.field.name, word.field.label}, names,
                                  std::string(word.word(view)), helps))
      frame.command("view", {{word.field.name, *name}});
  }
  const float second = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x / 2;
  bool right = false;
  for (const ViewFlag& flag : view_flags()) {
    const ViewField& field = flag.field;
    if (field.label == nullptr) continue;
    if (right) ImGui::SameLine(second);
    if (const auto on = w.checkbox({field.name, field.label, capitalised(field.help) + "."},
                                   view.*flag.value)) {
      frame.command("view", {{field.name, *on}});
    }
    right = !right;
  }
  if (right) ImGui::SameLine(second);
  const Session& session = frame.session;
  {
    const bool intruder = session.loaded() && session.world().intruder() >= 0;
    const Widgets::Disabled disabled(w, !intruder);
    if (const auto on =
            w.checkbox({"follow", "Follow intruder", "Keeps the intruder in the middle."},
                       session.view.follow)) {
      frame.command("camera", {{"follow", *on ? "intruder" : "none"}});
    }
  }
  show_camera(frame);
  show_numbers(frame);
  w.end_section();
}

}  // namespace quicksand::gui
