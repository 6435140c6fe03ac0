// The only file that knows OSMesa.
#include "render/base/render_error.h"
#include "render/gl/offscreen.h"

#if QUICKSAND_OSMESA
#include <GL/osmesa.h>

#include <array>
#include <string>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
// OSMesa keeps a few hundred bytes for good; leaks are looked for in our own code.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
#endif

namespace quicksand {
namespace {

class OsMesaContext final : public GlContext {
 public:
  OsMesaContext() {
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
    context_ = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
    if (context_ == nullptr)
      throw RenderError(
          "no OpenGL 3.3 context for drawing: OSMesa could not make one. Install the package "
          "libosmesa6, and unset GALLIUM_DRIVER if it is set.");
  }
  ~OsMesaContext() override {
    if (is_current()) OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    OSMesaDestroyContext(context_);
  }

  bool is_current() const override { return OSMesaGetCurrentContext() == context_; }
  void make_current(int width, int height) override {
    surface_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    if (OSMesaMakeCurrent(context_, surface_.data(), GL_UNSIGNED_BYTE, width, height) != GL_TRUE)
      throw RenderError("no drawing surface of " + std::to_string(width) + "x" +
                        std::to_string(height) + " pixels: OSMesa refused it");
    OSMesaPixelStore(OSMESA_Y_UP, 0);
  }
  GlFunction function(const char* name) const override { return OSMesaGetProcAddress(name); }
  const std::uint8_t* pixels() override { return surface_.data(); }

 private:
  OSMesaContext context_ = nullptr;
  std::vector<std::uint8_t> surface_;
};

}  // namespace

std::unique_ptr<GlContext> osmesa_context() { return std::make_unique<OsMesaContext>(); }

}  // namespace quicksand

#else

namespace quicksand {

std::unique_ptr<GlContext> osmesa_context() {
  throw RenderError("this program was built without OSMesa.");
}

}  // namespace quicksand

#endif
