#include "app/gui/imgui_input.h"

#include <algorithm>
#include <cfloat>
#include <iterator>

namespace quicksand::gui {
namespace {

// ImGui takes keys as events from 1.87 on, names modifiers as here from 1.89 on, and drops the array of keys later.
#if IMGUI_VERSION_NUM >= 18900
#define QUICKSAND_KEY_EVENTS 1
#else
#define QUICKSAND_KEY_EVENTS 0
#endif

constexpr struct {
  ImGuiKey theirs;
  Key ours;
} kKeys[] = {{ImGuiKey_Tab, Key::tab},
             {ImGuiKey_LeftArrow, Key::left},
             {ImGuiKey_RightArrow, Key::right},
             {ImGuiKey_UpArrow, Key::up},
             {ImGuiKey_DownArrow, Key::down},
             {ImGuiKey_PageUp, Key::page_up},
             {ImGuiKey_PageDown, Key::page_down},
             {ImGuiKey_Home, Key::home},
             {ImGuiKey_End, Key::end},
             {ImGuiKey_Insert, Key::insert},
             {ImGuiKey_Delete, Key::erase},
             {ImGuiKey_Backspace, Key::backspace},
             {ImGuiKey_Space, Key::space},
             {ImGuiKey_Enter, Key::enter},
             {ImGuiKey_Escape, Key::escape},
             {ImGuiKey_A, Key::a},
             {ImGuiKey_C, Key::c},
             {ImGuiKey_V, Key::v},
             {ImGuiKey_X, Key::x},
             {ImGuiKey_Y, Key::y},
             {ImGuiKey_Z, Key::z}};

void give_keys(const GuiInput& input, ImGuiIO& io) {
  const auto held = [&](Key key) { return std::ranges::find(input.keys, key) != input.keys.end(); };
#if QUICKSAND_KEY_EVENTS
  for (const auto& [theirs, ours] : kKeys) io.AddKeyEvent(theirs, held(ours));
  io.AddKeyEvent(ImGuiMod_Ctrl, held(Key::control));
  io.AddKeyEvent(ImGuiMod_Shift, held(Key::shift));
  io.AddKeyEvent(ImGuiMod_Alt, held(Key::alt));
#else
  for (const auto& [theirs, ours] : kKeys) io.KeysDown[static_cast<int>(ours)] = held(ours);
  io.KeyCtrl = held(Key::control);
  io.KeyShift = held(Key::shift);
  io.KeyAlt = held(Key::alt);
#endif
}

}  // namespace

void prepare_input(ImGuiIO& io) {
#if QUICKSAND_KEY_EVENTS
  io.ConfigInputTrickleEventQueue = false;  // all that a frame is given happens in that frame
#else
  for (const auto& [theirs, ours] : kKeys) io.KeyMap[theirs] = static_cast<int>(ours);
#endif
}

void give_input(const GuiInput& input, ImGuiIO& io) {
  const bool outside = input.mouse.x() < 0 || input.mouse.y() < 0;
  io.MousePos =
      outside ? ImVec2(-FLT_MAX, -FLT_MAX)
              : ImVec2(static_cast<float>(input.mouse.x()), static_cast<float>(input.mouse.y()));
  std::copy(input.buttons.begin(), input.buttons.end(), std::begin(io.MouseDown));
  io.MouseWheel = static_cast<float>(input.wheel);
  give_keys(input, io);
  io.AddInputCharactersUTF8(input.text.c_str());
}

}  // namespace quicksand::gui
