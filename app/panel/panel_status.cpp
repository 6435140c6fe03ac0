// The line along the bottom, and the banner of an error.
#include <imgui.h>

#include "app/panel/panel_frame.h"
#include "app/view/film.h"
#include "core/base/format.h"
#include "core/problem/solver_settings.h"
#include "render/base/nice_numbers.h"

namespace quicksand::gui {
namespace {

double tolerance(const Session& session) {
  const Phase* phase = session.protocol().phase();
  const double general = session.protocol().scenario().solver.tolerance;
  return phase == nullptr ? general : phase->solver_tolerance.value_or(general);
}

// Large numbers in groups of three.
std::string grouped(std::int64_t number) {
  std::string text = std::to_string(number);
  constexpr const char* kThinGap = "\u00A0";
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), kThinGap);
  }
  return text;
}

// Text on a coloured ground, at the right end of the line, over what may stand there.
void chip(const Widgets& w, const std::string& text, ImU32 ground, ImU32 ink) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float pad = w.px(8);
  ImGui::SameLine();
  const float right = ImGui::GetWindowContentRegionMax().x;
  const ImVec2 at(std::floor(right - size.x - 2 * pad), ImGui::GetCursorScreenPos().y);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled({at.x, at.y - w.px(1)}, {at.x + size.x + 2 * pad, at.y + size.y + w.px(1)},
                      ground, w.px(3));
  list->AddText({at.x + pad, at.y}, ink, text.c_str());
}

}  // namespace

void show_status(PanelFrame& frame) {
  const Widgets& w = frame.widgets;
  const Session& session = frame.session;
  if (!session.loaded()) {
    ImGui::PushStyleColor(ImGuiCol_Text, w.colours().faint);
    ImGui::TextUnformatted("no scene");
    ImGui::PopStyleColor();
    return;
  }
  const World& world = session.world();
  bool first = true;
  // Each reading keeps its place while numbers change: it is as wide as its longest text.
  const auto put = [&](const std::string& name, const std::string& value, float width) {
    if (!first) ImGui::SameLine(0, w.px(16));
    first = false;
    const float start = ImGui::GetCursorPosX();
    ImGui::PushStyleColor(ImGuiCol_Text, w.colours().faint);
    ImGui::TextUnformatted(name.c_str());
    ImGui::PopStyleColor();
    ImGui::SameLine(0, w.px(6));
    ImGui::TextUnformatted(value.c_str());
    ImGui::SameLine(start + w.px(width), 0);
    ImGui::Dummy(ImVec2(0, ImGui::GetTextLineHeight()));
  };
  put("Step", grouped(world.step), 100);
  put("Time", fixed_number(world.time, 3) + " √(d/g)", 136);
  put("Bodies", grouped(world.disks.size()), 96);
  if (frame.notes.steps_per_second) {
    put("Steps/s", grouped(std::llround(*frame.notes.steps_per_second)), 96);
  }
  put("Residual",
      // A state that was restored tells nothing of the step that led to it.
      (session.protocol().last_step().seconds > 0
           ? short_number(session.protocol().last_step().solve.residual.natural)
           : std::string("–")) +
          " of " + short_number(tolerance(session)),
      170);
  const std::int64_t unconverged = session.protocol().state().unconverged_steps;
  std::string warning;
  const bool nscd = session.scenario().step.nscd.has_value();
  if (nscd) put("Method", method_label(session.scenario()), 150);
  if (const std::string found = session.newest_critical_force(); !found.empty())
    put("Critical force", found, 230);
  if (session.failed()) {
    warning = "Stopped: a step did not converge";
  } else if (nscd) {
    // Its steps do not converge, by design.
    warning = "Not converged by design: depends on sweeps and dt";
  } else if (unconverged > 0) {
    warning = grouped(unconverged) + " " + noun_for(static_cast<double>(unconverged), "step") +
              " did not converge";
  }
  if (!warning.empty()) {
    const bool failed = session.failed();
    chip(w, warning, failed ? w.colours().error : w.colours().warning,
         failed ? w.colours().on_error : w.colours().on_warning);
  } else if (session.finished()) {
    chip(w, "Finished", w.colours().hovered, w.colours().ink);
  }
}

void show_banner(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  const float dismiss = w.px(80);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  ImGui::PushStyleColor(ImGuiCol_Text, w.colours().on_error);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - dismiss - gap);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(frame.notes.error.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - dismiss);
  if (w.button({"Dismiss error", "Dismiss"}, dismiss)) frame.notes.error.clear();
}

}  // namespace quicksand::gui
