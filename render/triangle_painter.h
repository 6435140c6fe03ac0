// Paints a list of triangles with the GL, and keeps their textures.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/canvas.h"
#include "render/triangles.h"

namespace quicksand {

class TrianglePainter {
 public:
  TrianglePainter();  // throws RenderError

  // White with this opacity (height, width), smooth between its points: letters.
  Texture add_opacity(int width, int height, std::span<const std::uint8_t> opacity);
  // A picture, black at first; its points stay sharp.
  Texture add_picture();
  void set_picture(Texture texture, const Image& image);

  Image paint(const TriangleList& list);

 private:
  Texture add(GLint filter);
  void bind(Texture texture);

  struct Size {
    int width = 0, height = 0;
  };
  Canvas canvas_;
  CanvasProgram program_;
  GLuint indices_ = 0;
  std::vector<GLuint> textures_;  // by Texture
  std::vector<Size> sizes_;
};

}  // namespace quicksand
