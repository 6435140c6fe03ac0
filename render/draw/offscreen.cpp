#include "render/draw/offscreen.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "render/base/render_error.h"

#if defined(__SANITIZE_ADDRESS__)
// OSMesa keeps a few hundred bytes for good; leaks are looked for in our own code.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
#endif

namespace quicksand {
namespace {

// Wide vectors crash on some systems; threads and caches make runs differ in time, not in pixels.
void set_reproducible_environment() {
  constexpr int kKeepWhatTheUserSet = 0;
  setenv("GALLIUM_DRIVER", "llvmpipe", kKeepWhatTheUserSet);
  setenv("LP_NATIVE_VECTOR_WIDTH", "128", kKeepWhatTheUserSet);
  setenv("MESA_SHADER_CACHE_DISABLE", "1", kKeepWhatTheUserSet);
  setenv("LP_NUM_THREADS", "0", kKeepWhatTheUserSet);
}

}  // namespace

struct Offscreen::Impl {
  OSMesaContext context = nullptr;
  int width = 0, height = 0;
  std::vector<std::uint8_t> surface;
};

Offscreen::Offscreen() : impl_(std::make_unique<Impl>()) {
  set_reproducible_environment();
  constexpr std::array<int, 13> kAttributes{OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_DEPTH_BITS,
                                            0,
                                            OSMESA_PROFILE,
                                            OSMESA_CORE_PROFILE,
                                            OSMESA_CONTEXT_MAJOR_VERSION,
                                            3,
                                            OSMESA_CONTEXT_MINOR_VERSION,
                                            3,
                                            0,
                                            0,
                                            0};
  impl_->context = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
  if (impl_->context == nullptr) {
    throw RenderError(
        "no OpenGL 3.3 context for drawing: OSMesa could not make one. Install the package "
        "libosmesa6, and unset GALLIUM_DRIVER if it is set.");
  }
  make_current(1, 1);
}

Offscreen::~Offscreen() {
  if (OSMesaGetCurrentContext() == impl_->context) {
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  }
  OSMesaDestroyContext(impl_->context);
}

void Offscreen::make_current(int width, int height) {
  if (OSMesaGetCurrentContext() == impl_->context && width == impl_->width &&
      height == impl_->height) {
    return;
  }
  impl_->width = width;
  impl_->height = height;
  impl_->surface.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  if (OSMesaMakeCurrent(impl_->context, impl_->surface.data(), GL_UNSIGNED_BYTE, width, height) !=
      GL_TRUE) {
    throw RenderError("no drawing surface of " + std::to_string(width) + "x" +
                      std::to_string(height) + " pixels: OSMesa refused it");
  }
  OSMesaPixelStore(OSMESA_Y_UP, 0);
}

void Offscreen::make_current() { make_current(impl_->width, impl_->height); }

Offscreen::Function Offscreen::function(const char* name) { return OSMesaGetProcAddress(name); }

const std::uint8_t* Offscreen::pixels() const { return impl_->surface.data(); }

}  // namespace quicksand
