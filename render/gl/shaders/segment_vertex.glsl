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
