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
