#version 330 core
// A line thinner than a pixel covers as much of it as it is wide.
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
