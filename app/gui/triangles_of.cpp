#include "app/gui/triangles_of.h"

#include <algorithm>

namespace quicksand::gui {

Colour colour_of(ImU32 c) {
  return {static_cast<std::uint8_t>(c >> IM_COL32_R_SHIFT),
          static_cast<std::uint8_t>(c >> IM_COL32_G_SHIFT),
          static_cast<std::uint8_t>(c >> IM_COL32_B_SHIFT),
          static_cast<std::uint8_t>(c >> IM_COL32_A_SHIFT)};
}

TriangleList triangles_of(const ImDrawData& drawn) {
  TriangleList triangles;
  for (int k = 0; k < drawn.CmdListsCount; ++k) {
    const ImDrawList& list = *drawn.CmdLists[k];
    const auto first_vertex = static_cast<std::uint32_t>(triangles.vertices.size());
    for (const ImDrawVert& v : list.VtxBuffer) {
      triangles.vertices.push_back({v.pos.x, v.pos.y, v.uv.x, v.uv.y, colour_of(v.col)});
    }
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const std::uint32_t shift = first_vertex + command.VtxOffset;
      const std::size_t first = triangles.indices.size();
      for (unsigned i = 0; i < command.ElemCount; ++i) {
        triangles.indices.push_back(shift +
                                    list.IdxBuffer[static_cast<int>(command.IdxOffset + i)]);
      }
      const ImVec4& clip = command.ClipRect;  // left, top, right, bottom
      triangles.batches.push_back({.first = first,
                                   .count = command.ElemCount,
                                   .clip = {clip.x, clip.y, std::max(0.0F, clip.z - clip.x),
                                            std::max(0.0F, clip.w - clip.y)}});
    }
  }
  return triangles;
}

}  // namespace quicksand::gui
