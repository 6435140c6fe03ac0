// A frame's input, told to ImGui.
#pragma once

#include <imgui.h>

#include "app/gui/gui_input.h"

namespace quicksand::gui {

// Once for a context, before the first frame.
void prepare_input(ImGuiIO& io);
// Before each frame.
void give_input(const GuiInput& input, ImGuiIO& io);

}  // namespace quicksand::gui
