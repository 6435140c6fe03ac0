// The only file that knows EGL: a context of Mesa without a surface, drawing on a frame buffer of its own. libEGL is
// opened only when it is asked for, so that nobody needs it who draws through OSMesa.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "render/base/render_error.h"
#include "render/gl/gl_table.h"

namespace quicksand {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw RenderError("no OpenGL 3.3 context for drawing through EGL: " + why +
                    ". Install the packages libegl1 and libgl1-mesa-dri.");
}

// eglGetProcAddress gives the other functions of EGL, and those of the GL.
using GetProcAddress = GlFunction (*)(const char*);

GetProcAddress get_proc_address() {
  static void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) refuse("libEGL.so.1 cannot be opened");
  return reinterpret_cast<GetProcAddress>(dlsym(library, "eglGetProcAddress"));
}

template <class Function>
Function function_named(const char* name) {
  const GlFunction function = get_proc_address()(name);
  if (function == nullptr) refuse(std::string("it lacks ") + name);
  return reinterpret_cast<Function>(function);
}

class EglContext final : public GlContext {
 public:
  EglContext() {
    const auto get_display =
        function_named<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (function_named<PFNEGLINITIALIZEPROC>("eglInitialize")(display_, nullptr, nullptr) !=
        EGL_TRUE)
      refuse("it has no platform without a surface");
    bind_api_(EGL_OPENGL_API);
    constexpr std::array<EGLint, 3> kConfig{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    function_named<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig")(display_, kConfig.data(), &config, 1,
                                                              &configs);
    constexpr std::array<EGLint, 7> kAttributes{EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
    context_ = function_named<PFNEGLCREATECONTEXTPROC>("eglCreateContext")(
        display_, configs > 0 ? config : nullptr, EGL_NO_CONTEXT, kAttributes.data());
    if (context_ == EGL_NO_CONTEXT) refuse("it could not make one");
    make_current();
    frame_buffer_ = made<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers");
    colours_ = made<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers");
  }
  ~EglContext() override {
    if (is_current()) make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    function_named<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")(display_, context_);
  }

  bool is_current() const override { return current_() == context_; }

  void make_current(int width, int height) override {
    make_current();
    bind_frame_buffer_(GL_FRAMEBUFFER, frame_buffer_);
    if (width == width_ && height == height_) return;
    width_ = height_ = 0;  // where it fails there is no surface
    bind_render_buffer_(GL_RENDERBUFFER, colours_);
    storage_(GL_RENDERBUFFER, GL_RGBA8, width, height);
    attach_(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_);
    if (status_(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw RenderError("no drawing surface of " + std::to_string(width) + "x" +
                        std::to_string(height) + " pixels: the OpenGL of this system refused it");
    width_ = width;
    height_ = height;
  }

  GlFunction function(const char* name) const override { return get_proc_address()(name); }

  const std::uint8_t* pixels() override {
    const std::size_t row = static_cast<std::size_t>(width_) * 4;
    const auto rows = static_cast<std::size_t>(height_);
    surface_.resize(row * rows);
    read_(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, surface_.data());
    // They come from the bottom.
    for (std::size_t k = 0; k < rows / 2; ++k)
      std::swap_ranges(surface_.data() + k * row, surface_.data() + (k + 1) * row,
                       surface_.data() + (rows - 1 - k) * row);
    return surface_.data();
  }

 private:
  void make_current() {
    if (make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
      refuse("it cannot be used without a surface");
  }
  template <class Generate>
  static GLuint made(const char* generate) {
    GLuint name = 0;
    function_named<Generate>(generate)(1, &name);
    return name;
  }

  PFNEGLBINDAPIPROC bind_api_ = function_named<PFNEGLBINDAPIPROC>("eglBindAPI");
  PFNEGLMAKECURRENTPROC make_current_ = function_named<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
  PFNEGLGETCURRENTCONTEXTPROC current_ =
      function_named<PFNEGLGETCURRENTCONTEXTPROC>("eglGetCurrentContext");
  PFNGLBINDFRAMEBUFFERPROC bind_frame_buffer_ =
      function_named<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
  PFNGLBINDRENDERBUFFERPROC bind_render_buffer_ =
      function_named<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer");
  PFNGLRENDERBUFFERSTORAGEPROC storage_ =
      function_named<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage");
  PFNGLFRAMEBUFFERRENDERBUFFERPROC attach_ =
      function_named<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer");
  PFNGLCHECKFRAMEBUFFERSTATUSPROC status_ =
      function_named<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("glCheckFramebufferStatus");
  PFNGLREADPIXELSPROC read_ = function_named<PFNGLREADPIXELSPROC>("glReadPixels");

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  GLuint frame_buffer_ = 0, colours_ = 0;
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> surface_;
};

}  // namespace

std::unique_ptr<GlContext> egl_context() { return std::make_unique<EglContext>(); }

}  // namespace quicksand
