// A drawing context without display or graphics card. The only file that knows OSMesa, so that
// another context (EGL without surface) can take its place.
#pragma once

#include <cstdint>
#include <memory>

namespace quicksand {

class Offscreen {
 public:
  using Function = void (*)();

  // An OpenGL 3.3 core context on the software rasteriser. Sets, before making it, the environment
  // variables that make pixels reproducible, unless the user has set them. Throws RenderError.
  Offscreen();
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

  // Makes this the context of the calling thread, drawing on a surface of that size [px].
  void make_current(int width, int height);
  // The same, of the size that it has.
  void make_current();
  // Address of a GL function, null if there is none.
  static Function function(const char* name);
  // What was drawn, after glFinish: RGBA, rows from the top (height, width, 4).
  const std::uint8_t* pixels() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quicksand
