// Paints a list of triangles with the GL, over a picture that is there already.
//
// That picture does not go through the GL as a texture: to lay it below afterwards, by the opacity that
// the triangles leave, takes a tenth of the time.
#pragma once

#include <cstdint>
#include <span>

#include "render/draw/canvas.h"
#include "render/draw/triangles.h"

namespace quicksand {

class TrianglePainter {
 public:
  TrianglePainter();  // throws RenderError

  // The atlas of letters: opacities (height, width), smooth between its points.
  void use_letters(int width, int height, std::span<const std::uint8_t> opacity);
  // The triangles over `picture`, whose size is that of the result.
  Image paint(const TriangleList& list, Image picture);

 private:
  Canvas canvas_;
  CanvasProgram program_;
  GLuint indices_ = 0;
  GLuint letters_ = 0;
};

}  // namespace quicksand
