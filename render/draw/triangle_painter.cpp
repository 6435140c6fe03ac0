#include "render/draw/triangle_painter.h"

#include <array>
#include <cstddef>
#include <vector>

#include "quicksand_shaders.h"

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
  const GlTable& gl = canvas_.gl();
  gl.GenBuffers(1, &indices_);
  gl.GenTextures(1, &letters_);
  // On a ground without opacity: what comes out are colours times opacity, and opacity.
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void TrianglePainter::use_letters(int width, int height, std::span<const std::uint8_t> opacity) {
  canvas_.make_current();
  const GlTable& gl = canvas_.gl();
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, letters_);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE,
                opacity.data());
}

Image TrianglePainter::paint(const TriangleList& list, Image picture) {
  canvas_.clear(picture.width, picture.height, with_alpha(hex(0x000000), 0));
  const GlTable& gl = canvas_.gl();
  canvas_.use(program_, kVertex, sizeof(TriangleVertex), false);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  upload(gl, GL_ARRAY_BUFFER, list.vertices);
  upload(gl, GL_ELEMENT_ARRAY_BUFFER, list.indices);
  for (const TriangleList::Batch& batch : list.batches) {
    canvas_.clip_to(batch.clip);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.count), GL_UNSIGNED_INT,
                    // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset, as the GL takes it
                    reinterpret_cast<const void*>(batch.first * sizeof(std::uint32_t)));
  }
  canvas_.finish_over(picture);
  return picture;
}

}  // namespace quicksand
