#include "app/widgets/widgets.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

namespace quicksand::gui {
namespace {

PixelRect rect_of(const ImVec2& low, const ImVec2& high) {
  return {low.x, low.y, high.x - low.x, high.y - low.y};
}

// Where a tooltip of this size does not hide what it is about: right of the mouse, or below, or above it. Versions of
// ImGui differ in their own choice.
ImVec2 beside_the_mouse(const ImVec2& size) {
  const float cursor = 24, edge = 3;  // [px]
  const ImVec2 mouse = ImGui::GetMousePos(), room = ImGui::GetIO().DisplaySize;
  const auto inside = [edge](float at, float extent, float end) {
    return std::max(edge, std::min(at, end - edge - extent));
  };
  if (mouse.x + cursor + size.x <= room.x - edge)
    return {mouse.x + cursor, inside(mouse.y, size.y, room.y)};
  const bool below = mouse.y + cursor + size.y <= room.y - edge;
  return {inside(mouse.x, size.x, room.x), below ? mouse.y + cursor : mouse.y - 8 - size.y};
}

// Sets a colour until the end of the block.
class Tint {
 public:
  Tint(ImGuiCol which, ImU32 colour) { ImGui::PushStyleColor(which, colour); }
  ~Tint() { ImGui::PopStyleColor(); }
  Tint(const Tint&) = delete;
  Tint& operator=(const Tint&) = delete;
};

std::string shown(double value, bool integer) {
  char text[64];
  std::snprintf(text, sizeof text, integer ? "%.0f" : "%.6g", value);
  return text;
}

}  // namespace

void Widgets::begin(Theme theme, bool close_lists) {
  look_ = &look(theme);
  close_lists_ = close_lists;
  all_.clear();
  prefix_.clear();
}

Widgets::Disabled::Disabled(Widgets& widgets, bool when)
    : widgets_(widgets), before_(widgets.disabled_) {
  widgets.disabled_ = before_ || when;
  ImGui::BeginDisabled(when);
}

Widgets::Disabled::~Disabled() {
  ImGui::EndDisabled();
  widgets_.disabled_ = before_;
}

void Widgets::record(const std::string& name, Widget::Kind kind, std::string value) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 clip_low = list->GetClipRectMin(), clip_high = list->GetClipRectMax();
  const float x = (low.x + high.x) / 2, y = (low.y + high.y) / 2;
  all_.push_back(
      {.path = path(name),
       .kind = kind,
       .rect = rect_of(low, high),
       .clip = rect_of(clip_low, clip_high),
       .hovered = ImGui::IsItemHovered(),
       .visible = x >= clip_low.x && x < clip_high.x && y >= clip_low.y && y < clip_high.y,
       .disabled = disabled_,
       .value = std::move(value)});
}

void Widgets::tooltip(const std::string& text) const {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const std::string shown_text = capitalised(text);
  const ImVec2 padding(px(10), px(7));
  const float width = px(300);  // at which lines are wrapped, padding included
  const ImVec2 size = ImGui::CalcTextSize(shown_text.c_str(), nullptr, false, width - padding.x);
  ImGui::SetNextWindowPos(beside_the_mouse({size.x + 2 * padding.x, size.y + 2 * padding.y}));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0F);  // also of a disabled widget
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(width);
  ImGui::TextUnformatted(shown_text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar(2);
}

bool Widgets::begin_section(const std::string& name, bool open_at_first, bool open_now) {
  const Tint back(ImGuiCol_Header, look_->panel);
  const Tint hovered(ImGuiCol_HeaderHovered, look_->button);
  const Tint border(ImGuiCol_Border, IM_COL32_BLACK_TRANS);
  ImGui::PushFont(fonts_.bold);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(3), px(4)));
  ImGui::SetNextItemOpen(open_now || open_at_first, open_now ? ImGuiCond_Always : ImGuiCond_Once);
  const bool open = ImGui::CollapsingHeader(name.c_str());
  ImGui::PopStyleVar();
  ImGui::PopFont();
  record(name, Widget::Kind::section, open ? "open" : "closed");
  if (open) prefix_ += name + "/";
  return open;
}

bool Widgets::begin_group(const std::string& name, bool open_at_first) {
  const Tint hovered(ImGuiCol_HeaderHovered, look_->button);
  ImGui::Dummy(ImVec2(0, px(1)));
  ImGui::SetNextItemOpen(open_at_first, ImGuiCond_Once);
  const bool open = ImGui::TreeNodeEx(
      name.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
  record(name, Widget::Kind::section, open ? "open" : "closed");
  if (open) prefix_ += name + "/";
  return open;
}

void Widgets::end_section() {
  prefix_.pop_back();
  const std::size_t slash = prefix_.rfind('/');
  prefix_.resize(slash == std::string::npos ? 0 : slash + 1);
}

void Widgets::line_label(const Label& label) const {
  if (label.bare) return;
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted((label.text.empty() ? label.name : label.text).c_str());
  tooltip(label.help);
  ImGui::SameLine(left + label_width());
}

void Widgets::line_unit(const Label& label) const {
  if (label.unit.empty()) return;
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width =
      unit(ImGui::GetWindowDrawList(), {at.x, at.y + ImGui::GetStyle().FramePadding.y}, label.unit);
  ImGui::Dummy(ImVec2(width, ImGui::GetTextLineHeight()));
}

float Widgets::unit(ImDrawList* list, const ImVec2& at, const std::string& text) const {
  const ImU32 colour = ImGui::GetColorU32(look_->faint);
  float x = at.x;
  const auto put = [&](ImFont* font, float drop, const std::string& piece) {
    if (list != nullptr) {
      list->AddText(font, font->FontSize, {std::round(x), at.y + drop}, colour, piece.c_str());
    }
    x += font->CalcTextSizeA(font->FontSize, 1e6F, 0, piece.c_str()).x;
  };
  std::size_t start = 0;
  while (start < text.size()) {
    const std::size_t mark = std::min(text.find('_', start), text.size());
    put(fonts_.text, 0, text.substr(start, mark - start));
    if (mark + 1 < text.size()) put(fonts_.index, px(5), text.substr(mark + 1, 1));
    start = mark + 2;
  }
  return x - at.x;
}

bool Widgets::button(const Label& label, float width, bool first_choice) {
  const Tint back(ImGuiCol_Button, first_choice ? look_->accent : look_->button);
  const Tint hovered(ImGuiCol_ButtonHovered, first_choice ? look_->accent_hovered : look_->hovered);
  const Tint active(ImGuiCol_ButtonActive, first_choice ? look_->accent_hovered : look_->pressed);
  const Tint ink(ImGuiCol_Text, first_choice ? look_->on_accent : look_->ink);
  const Tint border(ImGuiCol_Border, first_choice ? look_->accent : look_->line);
  const std::string& text = label.text.empty() ? label.name : label.text;
  const bool pressed = ImGui::Button((text + "###" + path(label.name)).c_str(), ImVec2(width, 0));
  record(label.name, Widget::Kind::button);
  tooltip(label.help);
  return pressed;
}

std::optional<bool> Widgets::checkbox(const Label& label, bool on) {
  const std::string& text = label.text.empty() ? label.name : label.text;
  bool value = on;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(8), px(2)));
  const bool changed = ImGui::Checkbox((text + "###" + path(label.name)).c_str(), &value);
  ImGui::PopStyleVar();
  record(label.name, Widget::Kind::checkbox, on ? "on" : "off");
  tooltip(label.help);
  return changed ? std::optional<bool>(value) : std::nullopt;
}

std::optional<std::string> Widgets::combo(const Label& label,
                                          const std::vector<std::string>& choices,
                                          const std::string& chosen,
                                          const std::vector<std::string>& helps) {
  if (!begin_list(label, chosen)) return std::nullopt;
  std::optional<std::string> given;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (choice(choices[i], choices[i] == chosen)) given = choices[i];
    if (i < helps.size()) tooltip(helps[i]);
  }
  end_list(label, chosen);
  return given;
}

bool Widgets::begin_list(const Label& label, const std::string& chosen) {
  line_label(label);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (ImGui::BeginCombo(("###" + path(label.name)).c_str(), chosen.c_str(),
                        ImGuiComboFlags_HeightLarge)) {
    prefix_ += label.name + "/";
    return true;
  }
  record(label.name, Widget::Kind::combo, chosen);
  tooltip(label.help);
  return false;
}

bool Widgets::choice(const std::string& text, bool now, bool stays_open) {
  const bool given = ImGui::Selectable(
      (text + "###" + path(text)).c_str(), now,
      stays_open ? ImGuiSelectableFlags_DontClosePopups : ImGuiSelectableFlags_None);
  record(text, Widget::Kind::choice);
  return given;
}

void Widgets::end_list(const Label& label, const std::string& chosen) {
  // Until here the popup was the present window, and the combo not the last item.
  end_section();
  if (close_lists_) ImGui::CloseCurrentPopup();
  ImGui::EndCombo();
  record(label.name, Widget::Kind::combo, chosen);
}

std::optional<double> Widgets::number(const Label& label, double value, bool integer) {
  line_label(label);
  const std::string key = path(label.name);
  const auto pending = numbers_.find(key);
  double now = pending == numbers_.end() ? value : pending->second;
  const float speed = static_cast<float>(std::max({std::abs(now) * 0.01, integer ? 0.1 : 1e-4}));
  ImGui::SetNextItemWidth(field_width());
  ImGui::DragScalar(("###" + key).c_str(), ImGuiDataType_Double, &now, speed, nullptr, nullptr,
                    integer ? "%.0f" : "%.6g", ImGuiSliderFlags_NoRoundToFormat);
  if (integer) now = std::round(now);
  const bool active = ImGui::IsItemActive();
  const bool finished = ImGui::IsItemDeactivated();
  record(label.name, Widget::Kind::number, shown(now, integer));
  if (!active) tooltip(label.help);
  line_unit(label);
  if (active) {
    numbers_[key] = now;
    return std::nullopt;
  }
  numbers_.erase(key);
  return finished && now != value ? std::optional<double>(now) : std::nullopt;
}

void Widgets::no_number(const Label& label) {
  const Disabled disabled(*this, true);
  line_label(label);
  ImGui::SetNextItemWidth(field_width());
  double none = 0;
  ImGui::DragScalar(("###" + path(label.name)).c_str(), ImGuiDataType_Double, &none, 1, nullptr,
                    nullptr, "–");
  record(label.name, Widget::Kind::number);
  tooltip(label.help);
  line_unit(label);
}

std::optional<std::string> Widgets::text(const Label& label, const std::string& value) {
  line_label(label);
  const std::string key = path(label.name);
  const auto pending = texts_.find(key);
  std::string now = pending == texts_.end() ? value : pending->second;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  ImGui::InputText(("###" + key).c_str(), &now, ImGuiInputTextFlags_AutoSelectAll);
  const bool active = ImGui::IsItemActive();
  const bool finished = ImGui::IsItemDeactivated();
  record(label.name, Widget::Kind::text, now);
  if (!active) tooltip(label.help);
  if (active) {
    texts_[key] = now;
    return std::nullopt;
  }
  texts_.erase(key);
  return finished && now != value ? std::optional<std::string>(now) : std::nullopt;
}

void Widgets::caption(const std::string& text) {
  const Tint ink(ImGuiCol_Text, look_->faint);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

void Widgets::refusal(const std::string& name, const std::string& text) {
  const Tint ink(ImGuiCol_Text, look_->error);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  record(name, Widget::Kind::refusal, text);
}

void Widgets::reading(const std::string& label, const std::string& value) {
  {
    const Tint ink(ImGuiCol_Text, look_->faint);
    ImGui::TextUnformatted(label.c_str());
  }
  ImGui::SameLine();
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(value.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, std::floor(room)));
  ImGui::TextUnformatted(value.c_str());
}

void Widgets::progress(double share) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = px(4);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(at, {at.x + width, at.y + height}, look_->hovered, px(2));
  const float done = width * static_cast<float>(std::clamp(share, 0.0, 1.0));
  if (done > px(1)) {
    list->AddRectFilled(at, {at.x + done, at.y + height}, look_->accent, px(2));
  }
  ImGui::Dummy(ImVec2(width, height));
}

}  // namespace quicksand::gui
