// What ImGui wants to be drawn, as triangles for the painter.
#pragma once

#include <imgui.h>

#include "render/draw/triangles.h"

namespace quicksand::gui {

Colour colour_of(ImU32 colour);

// All of them take their letters from the one atlas of the fonts.
TriangleList triangles_of(const ImDrawData& drawn);

}  // namespace quicksand::gui
