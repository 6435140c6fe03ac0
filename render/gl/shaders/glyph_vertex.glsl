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
