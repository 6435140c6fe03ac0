// The picture of the packing, with the mouse upon it: pick a grain, pull at it, zoom.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panel/panel_frame.h"
#include "app/session/disk_at.h"
#include "core/world/shaped_contact.h"

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
    grip = {.body = disk_at(world, picture.camera_at(pixel).to_world(pixel)), .start = pixel};
  }
  if (active && grip.body >= 0) {
    const double least = frame.widgets.px(kLeastDrag);
    // What was computed is not pulled at.
    const bool far = (pixel - grip.start).norm() > least && frame.session.timeline() == nullptr;
    grip.pulls = grip.pulls || far;
    if (grip.pulls) pull(frame, grip, picture.camera_at(grip.start), pixel);
  }
  if (ImGui::IsItemDeactivated()) {
    if (grip.pulls) {
      frame.command("apply", {{"body", grip.body}, {"force", pair({0, 0})}});
    } else {
      const Vec2 place = picture.camera_at(grip.start).to_world(grip.start);
      frame.command("pick", {{"at", pair(place)}});
    }
    grip = {};
  }
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
