// Paints a draw list with the GL.
#pragma once

#include <array>

#include "render/draw/canvas.h"
#include "render/draw/draw_list.h"
#include "render/draw/font.h"

namespace quicksand {

class Painter {
 public:
  Painter();  // throws RenderError

  // The font whose letters the following draw lists hold.
  void use_font(const Font& font);
  Image paint(const DrawList& list);

 private:
  void upload(const DrawList& list);
  void draw(const DrawList::Batch& batch);

  Canvas canvas_;
  std::array<CanvasProgram, 3> programs_;  // by DrawList::Kind
  GLuint atlas_ = 0;
};

}  // namespace quicksand
