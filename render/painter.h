// Paints a draw list with the GL.
#pragma once

#include <array>

#include "render/draw_list.h"
#include "render/font.h"
#include "render/gl_table.h"
#include "render/image.h"
#include "render/offscreen.h"

namespace quicksand {

class Painter {
 public:
  Painter();  // throws RenderError

  // The font whose letters the following draw lists hold.
  void use_font(const Font& font);
  Image paint(const DrawList& list);

 private:
  struct Program {
    GLuint id = 0;
    GLint picture = -1;  // uniform
    GLuint vertex_array = 0;
    GLuint buffer = 0;
  };
  Program make_program(const char* vertex, const char* fragment);
  GLuint compile(GLenum stage, const char* const* parts, int count);
  void upload(const DrawList& list);
  void draw(const DrawList& list, const DrawList::Batch& batch);

  Offscreen offscreen_;
  GlTable gl_;
  std::array<Program, 3> programs_;  // by DrawList::Kind
  GLuint atlas_ = 0;
};

}  // namespace quicksand
