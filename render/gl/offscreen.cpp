#include "render/gl/offscreen.h"

#include <cstdlib>
#include <string>

#include "render/base/render_error.h"

namespace quicksand {
namespace {

// Wide vectors crash on some systems; threads and caches make runs differ in time, not in pixels.
void set_reproducible_environment() {
  constexpr int kKeepWhatTheUserSet = 0;
  setenv("GALLIUM_DRIVER", "llvmpipe", kKeepWhatTheUserSet);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", kKeepWhatTheUserSet);
  setenv("LP_NATIVE_VECTOR_WIDTH", "128", kKeepWhatTheUserSet);
  setenv("MESA_SHADER_CACHE_DISABLE", "1", kKeepWhatTheUserSet);
  setenv("LP_NUM_THREADS", "0", kKeepWhatTheUserSet);
}

std::unique_ptr<GlContext> chosen_context() {
  const char* variable = std::getenv("QUICKSAND_OFFSCREEN");
  const std::string chosen = variable == nullptr ? "" : variable;
  if (chosen == "osmesa") return osmesa_context();
  if (chosen == "egl") return egl_context();
  if (!chosen.empty())
    throw RenderError("QUICKSAND_OFFSCREEN is \"" + chosen + "\"; it can be osmesa or egl");
  try {
    return osmesa_context();
  } catch (const RenderError& osmesa) {
    try {
      return egl_context();
    } catch (const RenderError& egl) {
      throw RenderError(std::string(osmesa.what()) + " " + egl.what());
    }
  }
}

}  // namespace

std::unique_ptr<GlContext> offscreen_context() {
  set_reproducible_environment();
  std::unique_ptr<GlContext> context = chosen_context();
  context->make_current(1, 1);
  return context;
}

}  // namespace quicksand
