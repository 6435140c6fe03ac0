// A drawing context without display or graphics card: OpenGL 3.3 core on Mesa's software rasteriser, through OSMesa or,
// where that is missing or QUICKSAND_OFFSCREEN is "egl", through EGL without a surface.
#pragma once

#include <cstdint>
#include <memory>

namespace quicksand {

using GlFunction = void (*)();

// What each of the two gives.
class GlContext {
 public:
  GlContext() = default;
  virtual ~GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  virtual bool is_current() const = 0;
  // Makes this the context of the calling thread, drawing on a surface of that size [px].
  virtual void make_current(int width, int height) = 0;
  // Address of a GL function; null if there is none, where the context knows.
  virtual GlFunction function(const char* name) const = 0;
  // What was drawn, after glFinish: RGBA, rows from the top (height, width, 4).
  virtual const std::uint8_t* pixels() = 0;
};

// Throw RenderError where they cannot make one.
std::unique_ptr<GlContext> osmesa_context();
std::unique_ptr<GlContext> egl_context();

// The one of them that there is, current and of one pixel. Sets, before making it, the environment variables that make
// pixels reproducible, unless the user has set them.
std::unique_ptr<GlContext> offscreen_context();

}  // namespace quicksand
