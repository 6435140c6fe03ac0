#version 330 core
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
