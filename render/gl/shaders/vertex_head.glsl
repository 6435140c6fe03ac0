#version 330 core
// Before each vertex program.
uniform vec2 picture;  // [px]
vec2 corner() { return vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1); }
vec4 place(vec2 p) { return vec4(2.0 * p.x / picture.x - 1.0, 1.0 - 2.0 * p.y / picture.y, 0, 1); }
