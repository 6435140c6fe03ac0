// What ImGui wants to be drawn, as triangles for the painter.
#pragma once

#include <imgui.h>

#include "render/triangles.h"

namespace quicksand::gui {

// Texture ids of ImGui are our textures plus one: zero means none to it.
inline ImTextureID id_of(Texture texture) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui's ids are pointers
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture) + 1);
}
inline Texture texture_of(ImTextureID id) {
  return static_cast<Texture>(reinterpret_cast<std::uintptr_t>(id) - 1);
}

TriangleList triangles_of(const ImDrawData& drawn, Colour background);

}  // namespace quicksand::gui
