// The programs that paint one kind of shape each. A shape is an instance of a square, a little
// larger than the shape; its edge is antialiased by the share of a pixel that the shape covers,
// from the signed distance to the edge. Triangles of panels come last.
#pragma once

namespace quicksand::shaders {

// Before each vertex program.
constexpr const char* kVertexHead = R"(#version 330 core
uniform vec2 picture;  // [px]
vec2 corner() { return vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1); }
vec4 place(vec2 p) { return vec4(2.0 * p.x / picture.x - 1.0, 1.0 - 2.0 * p.y / picture.y, 0, 1); }
)";

constexpr const char* kDiskVertex = R"(
layout(location = 0) in vec4 disk;  // x, y, radius, width of the outline
layout(location = 1) in vec4 fill;
layout(location = 2) in vec4 outline;
out vec2 local;
flat out vec2 shape;
flat out vec4 fill_colour, outline_colour;
void main() {
  local = corner() * (disk.z + 1.0);
  shape = disk.zw;
  fill_colour = fill;
  outline_colour = outline;
  gl_Position = place(disk.xy + local);
}
)";

constexpr const char* kDiskFragment = R"(#version 330 core
in vec2 local;
flat in vec2 shape;
flat in vec4 fill_colour, outline_colour;
out vec4 colour;
void main() {
  float distance = length(local) - shape.x;
  float cover = clamp(0.5 - distance, 0.0, 1.0);
  float rim = shape.y > 0.0 ? clamp(0.5 + distance + shape.y, 0.0, min(1.0, shape.y)) : 0.0;
  colour = vec4(mix(fill_colour.rgb, outline_colour.rgb, rim * outline_colour.a),
                fill_colour.a * cover);
}
)";

constexpr const char* kSegmentVertex = R"(
layout(location = 0) in vec4 ends;
layout(location = 1) in vec2 form;  // width, round
layout(location = 2) in vec4 tint;
out vec2 local;  // along and across, from the middle
flat out vec3 shape;  // half length, half width, round
flat out vec4 tint_colour;
void main() {
  vec2 along = ends.zw - ends.xy;
  float size = length(along);
  vec2 axis = size > 0.0 ? along / size : vec2(1, 0);
  float half_width = 0.5 * form.x;
  shape = vec3(0.5 * size, half_width, form.y);
  tint_colour = tint;
  vec2 reach = vec2(0.5 * size + form.y * half_width + 1.0, half_width + 1.0);
  local = corner() * reach;
  gl_Position = place(0.5 * (ends.xy + ends.zw) + local.x * axis + local.y * vec2(-axis.y, axis.x));
}
)";

// A line thinner than a pixel covers as much of it as it is wide.
constexpr const char* kSegmentFragment = R"(#version 330 core
in vec2 local;
flat in vec3 shape;
flat in vec4 tint_colour;
out vec4 colour;
void main() {
  vec2 p = abs(local);
  float most = min(1.0, 2.0 * shape.y);
  float cover;
  if (shape.z > 0.5) {
    float distance = length(vec2(max(p.x - shape.x, 0.0), p.y)) - shape.y;
    cover = clamp(0.5 - distance, 0.0, most);
  } else {
    cover = clamp(0.5 + shape.y - p.y, 0.0, most) *
            clamp(0.5 + shape.x - p.x, 0.0, min(1.0, 2.0 * shape.x));
  }
  colour = vec4(tint_colour.rgb, tint_colour.a * cover);
}
)";

constexpr const char* kGlyphVertex = R"(
layout(location = 0) in vec4 box;
layout(location = 1) in vec2 corner_in_atlas;
layout(location = 2) in vec4 tint;
out vec2 texel;
flat out vec4 tint_colour;
void main() {
  vec2 local = (0.5 + 0.5 * corner()) * box.zw;
  texel = corner_in_atlas + local;
  tint_colour = tint;
  gl_Position = place(box.xy + local);
}
)";

constexpr const char* kGlyphFragment = R"(#version 330 core
uniform sampler2D atlas;
in vec2 texel;
flat in vec4 tint_colour;
out vec4 colour;
void main() {
  colour = vec4(tint_colour.rgb, tint_colour.a * texelFetch(atlas, ivec2(floor(texel)), 0).r);
}
)";

// Of a list of triangles, not of a square.
constexpr const char* kTriangleVertex = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 in_atlas;
layout(location = 2) in vec4 tint;
out vec2 atlas_place;
out vec4 tint_colour;
void main() {
  atlas_place = in_atlas;
  tint_colour = tint;
  gl_Position = place(position);
}
)";

constexpr const char* kTriangleFragment = R"(#version 330 core
uniform sampler2D atlas;
in vec2 atlas_place;
in vec4 tint_colour;
out vec4 colour;
void main() { colour = vec4(tint_colour.rgb, tint_colour.a * texture(atlas, atlas_place).r); }
)";

}  // namespace quicksand::shaders
