// The programs of render/gl/shaders, for those who draw with another GL: a browser paints disks and lines by the same.
#pragma once

#include <span>

namespace quicksand {

struct ShaderText {
  const char* name;  // "disk_vertex"
  const char* text;  // GLSL; a vertex program goes behind "vertex_head"
};
std::span<const ShaderText> shader_texts();

}  // namespace quicksand
