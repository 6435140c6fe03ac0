// How the packing is drawn, and from where.
#include <imgui.h>

#include "app/panel/panel_frame.h"

namespace quicksand::gui {
namespace {

constexpr double kZoom = 1.25;  // of a press on + or -

struct Switch {
  const char* name;  // as in the command
  const char* label;
  const char* help;
  bool View::*value;
};
constexpr Switch kSwitches[] = {
    {"bonds", "Bonds", "Lines along the active bonds.", &View::bonds},
    {"forces", "Forces", "Lines along the contacts, as wide as their normal force.", &View::forces},
    {"broken_bonds", "Broken bonds", "Bars where bonds broke, while their bodies stay close.",
     &View::broken_bonds},
    {"orientation", "Orientation", "A mark on each disk that turns with it.", &View::orientation},
    {"legend", "Legend", "What the colours mean.", &View::legend},
    {"scale_bar", "Scale bar", "How long a few diameters are.", &View::scale_bar},
    {"numbers", "Numbers", "Time and key numbers.", &View::numbers},
};

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

}  // namespace

void show_view_controls(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  const View& view = frame.session.view;
  if (!w.begin_section("View", true)) return;
  std::vector<std::string> names, helps;
  for (const ColouringInfo& colouring : colourings()) {
    names.emplace_back(colouring.name);
    helps.emplace_back(colouring.description);
  }
  if (const auto name =
          w.combo({"colour", "Colour by"}, names, std::string(info(view.colouring).name), helps)) {
    frame.command("view", {{"colour", *name}});
  }
  if (const auto theme = w.combo({"theme", "Theme"}, {"light", "dark"},
                                 view.theme == Theme::light ? "light" : "dark")) {
    frame.command("view", {{"theme", *theme}});
  }
  const float second = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x / 2;
  bool right = false;
  for (const Switch& choice : kSwitches) {
    if (right) ImGui::SameLine(second);
    if (const auto on = w.checkbox({choice.name, choice.label, choice.help}, view.*choice.value)) {
      frame.command("view", {{choice.name, *on}});
    }
    right = !right;
  }
  if (right) ImGui::SameLine(second);
  const Session& session = frame.session;
  ImGui::BeginDisabled(!session.loaded() || session.world().intruder() < 0);
  if (const auto on = w.checkbox({"follow", "Follow intruder", "Keeps the intruder in the middle."},
                                 session.follow_intruder)) {
    frame.command("camera", {{"follow", *on ? "intruder" : "none"}});
  }
  ImGui::EndDisabled();
  show_camera(frame);
  w.end_section();
}

}  // namespace quicksand::gui
