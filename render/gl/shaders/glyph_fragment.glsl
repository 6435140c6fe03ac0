#version 330 core
uniform sampler2D atlas;
in vec2 texel;
flat in vec4 tint_colour;
out vec4 colour;
void main() {
  colour = vec4(tint_colour.rgb, tint_colour.a * texelFetch(atlas, ivec2(floor(texel)), 0).r);
}
