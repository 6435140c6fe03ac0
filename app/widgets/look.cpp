#include "app/widgets/look.h"

#include <cctype>

#include "render/draw/font.h"

namespace quicksand::gui {
namespace {

constexpr float kTextSize = 16;   // height of a line of text [px at scale 1]
constexpr float kSmallSize = 14;  // the same, of numbers at axes and of captions
constexpr float kIndexSize = 12;

constexpr ImU32 rgb(std::uint32_t hex) {
  return IM_COL32((hex >> 16U) & 0xFFU, (hex >> 8U) & 0xFFU, hex & 0xFFU, 255);
}

constexpr Look kLight{
    .panel = rgb(0xF4F6F8),
    .ink = rgb(0x14171C),
    .faint = rgb(0x5B6470),
    .line = rgb(0xCBD2DA),
    .field = rgb(0xFFFFFF),
    .button = rgb(0xE4E9EE),
    .hovered = rgb(0xD5DDE5),
    .pressed = rgb(0xC3CED9),
    .accent = rgb(0x0B64A8),
    .accent_hovered = rgb(0x09538C),
    .on_accent = rgb(0xFFFFFF),
    .warning = rgb(0xF5C04A),
    .on_warning = rgb(0x3A2A00),
    .error = rgb(0xB3261E),
    .on_error = rgb(0xFFFFFF),
    .curve = rgb(0x0B64A8),
};

constexpr Look kDark{
    .panel = rgb(0x181D24),
    .ink = rgb(0xE6EAF0),
    .faint = rgb(0x9AA5B2),
    .line = rgb(0x343D48),
    .field = rgb(0x0F1319),
    .button = rgb(0x29313B),
    .hovered = rgb(0x364150),
    .pressed = rgb(0x435064),
    .accent = rgb(0x4FA3E3),
    .accent_hovered = rgb(0x74B8EA),
    .on_accent = rgb(0x0B1118),
    .warning = rgb(0xE0A93A),
    .on_warning = rgb(0x201700),
    .error = rgb(0xE5675C),
    .on_error = rgb(0x1B0806),
    .curve = rgb(0x6BB5EE),
};

// Latin 1, dashes and the signs of physics.
constexpr ImWchar kLetters[] = {0x0020, 0x00FF, 0x0394, 0x0394, 0x03B8, 0x03B8, 0x03BC, 0x03BC,
                                0x03C1, 0x03C1, 0x03C6, 0x03C6, 0x2013, 0x2014, 0x2026, 0x2026,
                                0x2212, 0x2212, 0x221A, 0x221A, 0x2264, 0x2265, 0};

}  // namespace

const Look& look(Theme theme) { return theme == Theme::light ? kLight : kDark; }

Fonts load_fonts(float scale) {
  Fonts fonts;
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 3;  // whatever the default of this ImGui
  const auto add = [&](const std::vector<unsigned char>& file, float size) {
    // ImGui reads only, although it does not say so.
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<unsigned char*>(file.data()),
                                                      static_cast<int>(file.size()), size * scale,
                                                      &config, kLetters);
  };
  fonts.files = {read_font_file("Roboto-Regular.ttf"), read_font_file("Roboto-Medium.ttf")};
  fonts.text = add(fonts.files[0], kTextSize);
  fonts.bold = add(fonts.files[1], kTextSize);
  fonts.small = add(fonts.files[0], kSmallSize);
  fonts.index = add(fonts.files[0], kIndexSize);
  return fonts;
}

void apply(const Look& look, float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = {12, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {8, 4};
  style.IndentSpacing = 12;
  style.ScrollbarSize = 10;
  style.ScrollbarRounding = 5;
  style.FrameRounding = 3;
  style.PopupRounding = 3;
  style.WindowRounding = 0;
  style.FrameBorderSize = 1;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.DisabledAlpha = 0.45F;
  style.ScaleAllSizes(scale);
  const auto set = [&](ImGuiCol which, ImU32 colour) {
    style.Colors[which] = ImGui::ColorConvertU32ToFloat4(colour);
  };
  set(ImGuiCol_Text, look.ink);
  set(ImGuiCol_TextDisabled, look.faint);
  set(ImGuiCol_WindowBg, look.panel);
  set(ImGuiCol_PopupBg, look.field);
  set(ImGuiCol_Border, look.line);
  set(ImGuiCol_FrameBg, look.field);
  set(ImGuiCol_FrameBgHovered, look.field);
  set(ImGuiCol_FrameBgActive, look.field);
  set(ImGuiCol_CheckMark, look.accent);
  set(ImGuiCol_Button, look.button);
  set(ImGuiCol_ButtonHovered, look.hovered);
  set(ImGuiCol_ButtonActive, look.pressed);
  set(ImGuiCol_Header, look.button);
  set(ImGuiCol_HeaderHovered, look.hovered);
  set(ImGuiCol_HeaderActive, look.pressed);
  set(ImGuiCol_Separator, look.line);
  set(ImGuiCol_ScrollbarBg, look.panel);
  set(ImGuiCol_ScrollbarGrab, look.line);
  set(ImGuiCol_ScrollbarGrabHovered, look.faint);
  set(ImGuiCol_ScrollbarGrabActive, look.faint);
  set(ImGuiCol_TextSelectedBg, (look.accent & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 90));
}

std::string capitalised(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(text.front()));
  return text;
}

std::string unit_text(const std::string& unit) {
  if (unit == "1") return {};
  if (unit == "grain masses") return "m_g";  // there is room for a symbol, and help says more
  std::string text = unit;
  constexpr std::string_view kRoot = "sqrt";
  const std::size_t at = text.find(kRoot);
  if (at != std::string::npos) text.replace(at, kRoot.size(), "√");
  return text;
}

}  // namespace quicksand::gui
