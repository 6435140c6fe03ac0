#version 330 core
uniform sampler2D atlas;
in vec2 atlas_place;
in vec4 tint_colour;
out vec4 colour;
void main() { colour = vec4(tint_colour.rgb, tint_colour.a * texture(atlas, atlas_place).r); }
