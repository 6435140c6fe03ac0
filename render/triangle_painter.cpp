#include "render/triangle_painter.h"

#include <array>
#include <cstddef>

#include "render/shaders.h"

namespace quicksand {
namespace {

constexpr std::array<Attribute, 3> kVertex{
    {{2, GL_FLOAT, offsetof(TriangleVertex, x)},
     {2, GL_FLOAT, offsetof(TriangleVertex, u)},
     {4, GL_UNSIGNED_BYTE, offsetof(TriangleVertex, colour)}}};

template <typename Element>
void upload(const GlTable& gl, GLenum target, const std::vector<Element>& elements) {
  gl.BufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(),
                GL_STREAM_DRAW);
}

}  // namespace

TrianglePainter::TrianglePainter()
    : program_(canvas_.make_program(shaders::kTriangleVertex, shaders::kTriangleFragment)) {
  canvas_.gl().GenBuffers(1, &indices_);
}

void TrianglePainter::bind(Texture texture) {
  canvas_.gl().ActiveTexture(GL_TEXTURE0);
  canvas_.gl().BindTexture(GL_TEXTURE_2D, textures_[static_cast<std::size_t>(texture)]);
}

Texture TrianglePainter::add(GLint filter) {
  canvas_.make_current();
  const GlTable& gl = canvas_.gl();
  const auto texture = static_cast<Texture>(textures_.size());
  textures_.push_back(0);
  sizes_.push_back({});
  gl.GenTextures(1, &textures_.back());
  bind(texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  return texture;
}

Texture TrianglePainter::add_opacity(int width, int height, std::span<const std::uint8_t> opacity) {
  const Texture texture = add(GL_LINEAR);
  const GlTable& gl = canvas_.gl();
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_ONE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_ONE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, GL_ONE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_A, GL_RED);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE,
                opacity.data());
  return texture;
}

Texture TrianglePainter::add_picture() {
  const Texture texture = add(GL_NEAREST);
  set_picture(texture, Image(1, 1));
  return texture;
}

void TrianglePainter::set_picture(Texture texture, const Image& image) {
  canvas_.make_current();
  bind(texture);
  const GlTable& gl = canvas_.gl();
  Size& size = sizes_[static_cast<std::size_t>(texture)];
  if (size.width == image.width && size.height == image.height) {
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE,
                     image.rgb.data());
    return;
  }
  size = {image.width, image.height};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                image.rgb.data());
}

Image TrianglePainter::paint(const TriangleList& list) {
  canvas_.clear(list.width, list.height, list.background);
  const GlTable& gl = canvas_.gl();
  canvas_.use(program_, kVertex, sizeof(TriangleVertex), false);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  upload(gl, GL_ARRAY_BUFFER, list.vertices);
  upload(gl, GL_ELEMENT_ARRAY_BUFFER, list.indices);
  for (const TriangleList::Batch& batch : list.batches) {
    bind(batch.texture);
    canvas_.clip_to(batch.clip);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.count), GL_UNSIGNED_INT,
                    // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset, as the GL takes it
                    reinterpret_cast<const void*>(batch.first * sizeof(std::uint32_t)));
  }
  return canvas_.finish();
}

}  // namespace quicksand
