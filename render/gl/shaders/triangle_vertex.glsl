// Of a list of triangles, not of a square.
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
