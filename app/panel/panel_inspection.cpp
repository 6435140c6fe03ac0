// The body that was picked: where it is, how it moves, what holds it.
#include <imgui.h>

#include <algorithm>

#include "app/panel/panel_frame.h"
#include "app/session/disk_at.h"
#include "render/base/nice_numbers.h"

namespace quicksand::gui {
namespace {

constexpr double kFirstStiffness = 10;  // where there is no cohesion [F_g/d]

std::string pair_text(double x, double y) {
  return "(" + short_number(x) + ", " + short_number(y) + ")";
}

void cell(const std::string& text, bool right) {
  ImGui::TableNextColumn();
  if (right) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, std::floor(room)));
  }
  ImGui::TextUnformatted(text.c_str());
}

// Forces that a body feels, with their partner and whether they are bonded.
void show_contacts(const PanelFrame& frame, int body) {
  const World& world = frame.session.world();
  const Widgets& w = frame.widgets;
  if (!ImGui::BeginTable("contacts", 4, ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::PushStyleColor(ImGuiCol_Text, w.colours().faint);
  for (const char* title : {"with", "normal", "tangential", "bond"}) {
    cell(title, std::string_view(title) != "with");
  }
  ImGui::PopStyleColor();
  for (const Contact& contact : world.contacts) {
    const auto [a, b] = world.rows(contact.pair);
    if (a != body && b != body) continue;
    const int other = a == body ? b : a;
    const double dt = world.impulse_dt;
    const bool loaded = dt > 0;
    cell(body_name(world, other), false);
    cell(loaded ? short_number(contact.normal_force(dt)) : "–", true);
    cell(loaded ? short_number(contact.impulse.y() / dt) : "–", true);
    const Bond* bond = world.bonds.find(contact.pair);
    cell(bond == nullptr ? "none" : bond->state == BondState::active ? "active" : "broken", true);
  }
  ImGui::EndTable();
  ImGui::PushFont(w.fonts().small);
  frame.widgets.caption(
      "Forces of the last step, in weights of a grain; those that press are positive.");
  ImGui::PopFont();
}

void show_body(PanelFrame& frame, int body) {
  Widgets& w = frame.widgets;
  const World& world = frame.session.world();
  const auto k = static_cast<std::size_t>(body);
  const Disks& disks = world.disks;
  const bool intruder = disks.role[k] == DiskRole::intruder;
  w.reading(intruder ? "Intruder" : "Grain", std::to_string(body));
  w.reading("Diameter [d]", short_number(2 * disks.radius[k]));
  w.reading("Position [d]", pair_text(disks.position[k].x(), disks.position[k].y()));
  w.reading("Velocity [√(g d)]", pair_text(disks.velocity[k].x(), disks.velocity[k].y()));
  w.reading("Spin [√(g/d)]", short_number(disks.velocity[k].z()));
  if (!disks.applied[k].isZero()) {
    w.reading("Applied force [weights]", pair_text(disks.applied[k].x(), disks.applied[k].y()));
  }
  const auto bonded = std::ranges::count_if(world.bonds.list, [&](const Bond& bond) {
    const auto [a, b] = world.rows(bond.pair);
    return bond.state == BondState::active && (a == body || b == body);
  });
  w.reading("Active bonds", std::to_string(bonded));
  show_contacts(frame, body);
}

}  // namespace

double drag_stiffness(const PanelFrame& frame) {
  if (frame.entries.drag_stiffness) return *frame.entries.drag_stiffness;
  return frame.session.scenario().grain_law.cohesion_force.value_or(kFirstStiffness);
}

void show_inspection(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  const Session& session = frame.session;
  // A body that was just picked is shown, wherever the panel stands.
  const bool fresh = session.picked && session.picked != frame.notes.inspected;
  frame.notes.inspected = session.picked;
  if (!w.begin_section("Inspect", false, fresh)) return;
  const bool there = session.loaded() && session.picked && *session.picked >= 0 &&
                     *session.picked < session.world().disks.size();
  if (there) {
    show_body(frame, *session.picked);
  } else {
    w.caption("Click on a grain to see what holds it. Drag from a grain to pull at it.");
  }
  if (session.loaded()) {
    if (const auto stiffness =
            w.number({"drag stiffness", "Drag with", "Force over the distance dragged.", "F_g/d"},
                     drag_stiffness(frame), false)) {
      frame.entries.drag_stiffness = *stiffness;
    }
  }
  if (fresh) ImGui::SetScrollHereY(1);
  w.end_section();
}

}  // namespace quicksand::gui
