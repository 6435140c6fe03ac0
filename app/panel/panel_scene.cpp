// Choice of the scene, and the simulation's controls.
#include <imgui.h>

#include "app/base/assets.h"
#include "app/base/status_line.h"
#include "app/panel/panel_frame.h"
#include "app/scene/opening.h"
#include "core/base/errors.h"

namespace quicksand::gui {

namespace {

namespace fs = std::filesystem;

void open(PanelFrame& frame, const std::string& path) {
  try {
    frame.commands.push_back(opening_command(path));
  } catch (const InputError& error) {
    frame.notes.error = error.where() + ": " + error.what();
  }
}

// Walks through folders. What is in them is read when the list opens, not at each picture.
void show_files(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  PanelEntries& entries = frame.entries;
  const Widgets::Label label{"open", "Open",
                             "A scene, a session, a saved state, or the folder of a run."};
  if (!w.begin_list(label, "a file or run …")) {
    entries.files.clear();
    return;
  }
  if (entries.folder.empty()) entries.folder = fs::current_path();
  if (entries.files.empty()) entries.files = openable_in(entries.folder);
  w.caption(entries.folder.string());
  std::string chosen;
  for (const std::string& name : entries.files)
    if (w.choice(name, false, name.ends_with('/'))) chosen = name;
  if (chosen.ends_with('/')) {
    entries.folder = (entries.folder / chosen.substr(0, chosen.size() - 1)).lexically_normal();
    if (!entries.folder.has_filename()) entries.folder = entries.folder.parent_path();
    entries.files.clear();
  } else if (!chosen.empty()) {
    open(frame, (entries.folder / chosen).string());
  }
  w.end_list(label, "a file or run …");
}

}  // namespace

void show_scene(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  if (!w.begin_section("Scene", true)) return;
  std::vector<std::string> names;
  for (const auto& path : shipped_scenes()) names.push_back(path.stem().string());
  const bool loaded = frame.session.loaded();
  const std::string& name = frame.session.scenario().name;
  if (const auto chosen = w.combo({"scene", "Scene", "Loads one of the example scenes."}, names,
                                  loaded ? name : "choose …")) {
    frame.command("load", {{"scene", *chosen}});
  }
  show_files(frame);
  if (const std::vector<std::string>& recent = frame.notes.recent; !recent.empty()) {
    const auto again =
        w.combo({"recent", "Recent", "Scenes and runs opened before."}, recent, "choose …");
    if (again) open(frame, *again);
  }
  w.end_section();
}

namespace {

void show_phases(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  const Protocol& protocol = frame.session.protocol();
  const int present = protocol.state().phase;
  int index = 0;
  for (const Phase& phase : frame.session.phases()) {
    const bool now = index == present, done = index < present;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 centre(at.x + w.px(6), at.y + line / 2);
    const ImU32 colour = now ? w.colours().accent : w.colours().faint;
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (now || done) {
      list->AddCircleFilled(centre, w.px(4), colour);
    } else {
      list->AddCircle(centre, w.px(3.5F), colour, 0, w.px(1));
    }
    ImGui::Dummy(ImVec2(w.px(12), line));
    ImGui::SameLine();
    ImGui::PushFont(now ? w.fonts().bold : w.fonts().text);
    ImGui::PushStyleColor(ImGuiCol_Text, now ? w.colours().ink : w.colours().faint);
    ImGui::TextUnformatted(std::string(phase_name(phase)).c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (now) {
      const int percent = static_cast<int>(100 * protocol.phase_progress());
      std::string progress = std::to_string(percent) + " %";
      if (frame.notes.eta_seconds) {
        progress += ", " + duration_text(*frame.notes.eta_seconds) + " left";
      }
      ImGui::SameLine();
      const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(progress.c_str()).x;
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, std::floor(room)));
      ImGui::TextUnformatted(progress.c_str());
      w.progress(protocol.phase_progress());
    }
    ++index;
  }
}

}  // namespace

void show_controls(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  const Session& session = frame.session;
  if (!w.begin_section("Controls", true)) return;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float third = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const bool over = session.loaded() && (session.finished() || session.failed());
  {
    const Widgets::Disabled disabled(w, over);
    if (w.button({"Run", session.running ? "Pause" : "Run", "Also by the space bar."}, third,
                 !session.running)) {
      frame.command(session.running ? "pause" : "start");
    }
    ImGui::SameLine();
    if (w.button({"Step", {}, "Computes one time step."}, third)) {
      frame.command("run", {{"steps", 1}});
    }
  }
  ImGui::SameLine();
  if (w.button({"Reset", {}, "Restarts the scene with its current values."}, third)) {
    frame.command("reset");
  }
  if (const auto steps = w.number(
          {"Steps per frame", {}, "Time steps between two pictures of the panel; starts the run."},
          static_cast<double>(session.steps_per_frame), true)) {
    frame.command("pace", {{"steps_per_frame", static_cast<std::int64_t>(*steps)}});
  }
  if (session.loaded()) show_phases(frame);
  w.end_section();
}

}  // namespace quicksand::gui
