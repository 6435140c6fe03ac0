// The picture of the packing, with the mouse upon it: point at a grain, pick it, pull at it; move and zoom.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panel/panel_frame.h"
#include "app/session/disk_at.h"
#include "core/base/format.h"
#include "core/world/shaped_contact.h"
#include "render/base/camera.h"
#include "render/base/nice_numbers.h"

namespace quicksand::gui {
namespace {

constexpr double kZoomOfANotch = 1.1;
constexpr float kLeastDrag = 4;  // [px at scale 1]; less is a click

ImVec2 at(const PixelRect& rect, const Vec2& pixel) {
  return {static_cast<float>(rect.x + pixel.x()), static_cast<float>(rect.y + pixel.y())};
}

Json pair(const Vec2& v) { return Json::array({v.x(), v.y()}); }

// Centre of a body in the picture, at the periodic image that the box shows [px].
Vec2 pixel_of(const World& world, const Camera& camera, int body) {
  const Vec2& centre = world.disks.position[static_cast<std::size_t>(body)];
  return camera.to_pixel({world.wrapped_x(centre.x()), centre.y()});
}

void draw_ring(const PanelFrame& frame, const Camera& camera, const PixelRect& rect, int body) {
  const World& world = frame.session.world();
  const Widgets& w = frame.widgets;
  const double radius = reach_of(world, body) * camera.scale();
  const ImVec2 centre = at(rect, pixel_of(world, camera, body));
  const float ring = static_cast<float>(radius) + w.px(2.5F);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddCircle(centre, ring, w.colours().field, 48, w.px(5));
  list->AddCircle(centre, ring, w.colours().accent, 48, w.px(2.5F));
}

void draw_arrow(const PanelFrame& frame, const ImVec2& from, const ImVec2& to) {
  const Widgets& w = frame.widgets;
  const float dx = to.x - from.x, dy = to.y - from.y;
  const float length = std::hypot(dx, dy);
  if (length < w.px(kLeastDrag)) return;
  const float head = std::min(length, w.px(11)), half = 0.4F * head;
  const float ux = dx / length, uy = dy / length;
  const ImVec2 neck(to.x - head * ux, to.y - head * uy);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddLine(from, neck, w.colours().accent, w.px(2.5F));
  list->AddTriangleFilled(to, {neck.x - half * uy, neck.y + half * ux},
                          {neck.x + half * uy, neck.y - half * ux}, w.colours().accent);
}

// The force that a drag to here commands: given again only when it changes.
void pull(PanelFrame& frame, Grip& grip, const Camera& camera, const Vec2& pixel) {
  const Vec2 apart = camera.to_world(pixel) - camera.to_world(grip.start);
  const Vec2 force = drag_stiffness(frame) * apart;
  if (force == grip.force) return;
  grip.force = force;
  frame.command("apply", {{"body", grip.body}, {"force", pair(force)}});
}

// The place under the mouse stays under it.
void move_along(PanelFrame& frame, Grip& grip, const Camera& camera, const Vec2& pixel) {
  const Vec2 by = camera.to_world(grip.last) - camera.to_world(pixel);
  if (by.isZero(0)) return;
  grip.last = pixel;
  const WorldRect shown = view_window(frame.session.world(), frame.session.shown());
  const Vec2 low = shown.low + by, high = shown.high + by;
  if (std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) > kFarthestWindow) return;
  frame.command("camera", {{"follow", "none"}, {"low", pair(low)}, {"high", pair(high)}});
}

// What is known of a body at a glance.
void tell_body(const PanelFrame& frame, int body) {
  const World& world = frame.session.world();
  const auto k = static_cast<std::size_t>(body);
  int touches = 0, bonds = 0;
  double pressed = 0;
  for (const Contact& contact : world.contacts) {
    const auto [a, b] = world.rows(contact.pair);
    if (a != body && b != body) continue;
    ++touches;
    if (world.impulse_dt > 0) pressed = std::max(pressed, contact.normal_force(world.impulse_dt));
  }
  for (const Bond& bond : world.bonds.list) {
    const auto [a, b] = world.rows(bond.pair);
    if (bond.state == BondState::active && (a == body || b == body)) ++bonds;
  }
  const bool intruder = world.disks.role[k] == DiskRole::intruder;
  frame.widgets.tooltip((intruder ? "intruder: " : "grain " + std::to_string(body) + ": ") +
                        count_text(touches, "contact") + ", " + count_text(bonds, "active bond") +
                        "\nspeed " + short_number(world.disks.velocity[k].head<2>().norm()) +
                        " √(g d), pressed with at most " + short_number(pressed) + " F_g");
}

void take_mouse(PanelFrame& frame, const ViewPicture& picture, Grip& grip, const PixelRect& rect) {
  const World& world = frame.session.world();
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 pixel(io.MousePos.x - rect.x, io.MousePos.y - rect.y);
  const bool active = ImGui::IsItemActive();
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    const Vec2 place = picture.camera_at(pixel).to_world(pixel);
    frame.command("camera", {{"zoom", std::pow(kZoomOfANotch, static_cast<double>(io.MouseWheel))},
                             {"at", pair(place)}});
  }
  if (ImGui::IsItemActivated()) {
    grip = {.body = disk_at(world, picture.camera_at(pixel).to_world(pixel)),
            .start = pixel,
            .last = pixel};
    if (grip.body < 0 && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      frame.command("camera", {{"fit", "box"}});
  }
  if (active && grip.body < 0) {
    grip.moves = grip.moves || (pixel - grip.start).norm() > frame.widgets.px(kLeastDrag);
    if (grip.moves) move_along(frame, grip, picture.camera_at(grip.start), pixel);
  }
  if (active && grip.body >= 0) {
    // What was computed is not pulled at.
    grip.pulls = grip.pulls || ((pixel - grip.start).norm() > frame.widgets.px(kLeastDrag) &&
                                frame.session.timeline() == nullptr);
    if (grip.pulls) pull(frame, grip, picture.camera_at(grip.start), pixel);
  }
  if (ImGui::IsItemDeactivated()) {
    if (grip.pulls) {
      frame.command("apply", {{"body", grip.body}, {"force", pair({0, 0})}});
    } else if (!grip.moves) {
      const Vec2 place = picture.camera_at(grip.start).to_world(grip.start);
      frame.command("pick", {{"at", pair(place)}});
    }
    grip = {};
  }
  if (!ImGui::IsItemHovered() || active) return;
  const int under = disk_at(world, picture.camera_at(pixel).to_world(pixel));
  if (under >= 0) tell_body(frame, under);
}

// Words on a ground of their own, in the middle of the picture's lower edge.
void draw_hint(const PanelFrame& frame, const ImVec2& low, const ImVec2& high) {
  const Widgets& w = frame.widgets;
  const char* text = frame.notes.hint.c_str();
  const float pad = w.px(10), least = w.px(60);
  const float width = std::max(least, std::min(w.px(420), high.x - low.x - 4 * pad));
  const ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, width);
  const ImVec2 corner(std::floor((low.x + high.x - size.x) / 2),
                      std::floor(high.y - size.y - w.px(72)));
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled({corner.x - pad, corner.y - pad},
                      {corner.x + size.x + pad, corner.y + size.y + pad}, w.colours().accent,
                      w.px(4));
  list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), corner, w.colours().field, text, nullptr,
                width);
}

}  // namespace

void show_view(PanelFrame& frame, ViewPicture& picture, Grip& grip, const PixelRect& rect) {
  Widgets& w = frame.widgets;
  if (rect.width < 1 || rect.height < 1) return;
  const ImVec2 low = at(rect, {0, 0}), high = at(rect, {rect.width, rect.height});
  ImGui::SetCursorScreenPos(low);
  ImGui::InvisibleButton("###view", {high.x - low.x, high.y - low.y});
  w.record("Picture", Widget::Kind::picture);
  if (!picture.shows()) {
    const char* text = frame.session.loaded() ? "No room for the picture" : "Choose a scene";
    const ImVec2 size = ImGui::CalcTextSize(text);
    ImGui::GetWindowDrawList()->AddText(
        {std::floor((low.x + high.x - size.x) / 2), std::floor((low.y + high.y - size.y) / 2)},
        w.colours().faint, text);
    return;
  }
  take_mouse(frame, picture, grip, rect);
  const std::optional<int>& picked = frame.session.picked;
  const World& world = frame.session.world();
  if (picked && *picked >= 0 && *picked < world.disks.size()) {
    draw_ring(frame, picture.camera(), rect, *picked);
  }
  if (grip.pulls && grip.body < world.disks.size()) {
    const Camera& camera = picture.camera_at(grip.start);
    draw_arrow(frame, at(rect, pixel_of(world, camera, grip.body)), ImGui::GetIO().MousePos);
  }
  if (!frame.notes.hint.empty()) draw_hint(frame, low, high);
}

}  // namespace quicksand::gui
