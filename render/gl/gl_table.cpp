#include "render/gl/gl_table.h"

#include <string>

#include "render/base/render_error.h"

namespace quicksand {
namespace {

template <typename Function>
void load_one(const GlContext& context, const char* name, Function& function) {
  function = reinterpret_cast<Function>(context.function(name));
  if (function == nullptr) {
    throw RenderError(std::string("the OpenGL of this system lacks ") + name +
                      "; install the package libosmesa6");
  }
}

}  // namespace

GlTable GlTable::load(const GlContext& context) {
  GlTable table;
#define QUICKSAND_GL_LOAD(name) load_one(context, "gl" #name, table.name);
  QUICKSAND_GL_FUNCTIONS(QUICKSAND_GL_LOAD)
#undef QUICKSAND_GL_LOAD
  return table;
}

}  // namespace quicksand
