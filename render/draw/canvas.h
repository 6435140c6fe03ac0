// A surface to paint on with the GL, as far as all painters need it: programs of shaders, buffers of
// shapes, clipping, and the picture that comes out.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "render/base/camera.h"
#include "render/base/colour.h"
#include "render/gl/gl_table.h"
#include "render/gl/offscreen.h"
#include "render/image/image.h"

namespace quicksand {

// One value of a shape or vertex, as it lies in memory.
struct Attribute {
  GLint size = 0;  // number of components
  GLenum type = GL_FLOAT;
  std::size_t offset = 0;  // [bytes]
};

// A pair of shaders with the buffer that feeds them.
struct CanvasProgram {
  GLuint id = 0;
  GLint picture = -1;  // uniform
  GLuint vertex_array = 0;
  GLuint buffer = 0;
};

class Canvas {
 public:
  Canvas();  // throws RenderError

  const GlTable& gl() const { return gl_; }
  // `vertex` is put behind shaders::kVertexHead. Throws RenderError.
  CanvasProgram make_program(const char* vertex, const char* fragment);

  void make_current() { make_current(width_, height_); }
  // Begins a picture.
  void clear(int width, int height, Colour background);
  // Selects program and buffer; each attribute advances by `stride` [bytes] with every vertex, or with
  // every instance. `start` is where the first one lies [bytes].
  void use(const CanvasProgram& program, std::span<const Attribute> attributes, std::size_t stride,
           bool per_instance, std::size_t start = 0);
  // Nothing is painted beyond (rounded outwards to whole pixels).
  void clip_to(const PixelRect& rect);
  Image finish();
  // Lays what was painted, in colours times opacity, over a picture of the same size.
  void finish_over(Image& picture);

 private:
  void make_current(int width, int height);
  GLuint compile(GLenum stage, std::span<const char* const> parts);

  std::unique_ptr<GlContext> context_ = offscreen_context();
  GlTable gl_;
  int width_ = 1, height_ = 1;  // of the picture [px]
  bool has_surface_ = false;    // of that size; none after one was refused
};

}  // namespace quicksand
