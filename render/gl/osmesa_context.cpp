// The only file that knows OSMesa. It is opened only when something is drawn: it brings LLVM, which takes three times as
// long to load as all the rest of the program.
#include "render/base/render_error.h"
#include "render/gl/offscreen.h"

#if QUICKSAND_OSMESA
#include <GL/osmesa.h>
#include <dlfcn.h>

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

[[noreturn]] void refuse(const std::string& why) {
  throw RenderError("no OpenGL 3.3 context for drawing: " + why +
                    ". Install the package libosmesa6, and unset GALLIUM_DRIVER if it is set.");
}

template <class Function>
void find(Function& function, const char* name) {
  static void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) refuse("libOSMesa.so.8 cannot be opened");
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) refuse(std::string("OSMesa lacks ") + name);
}

// What is used of it.
struct OsMesa {
  decltype(&OSMesaCreateContextAttribs) create = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetCurrentContext) current = nullptr;
  decltype(&OSMesaPixelStore) pixel_store = nullptr;
  decltype(&OSMesaGetProcAddress) gl_function = nullptr;

  OsMesa() {
    find(create, "OSMesaCreateContextAttribs");
    find(destroy, "OSMesaDestroyContext");
    find(make_current, "OSMesaMakeCurrent");
    find(current, "OSMesaGetCurrentContext");
    find(pixel_store, "OSMesaPixelStore");
    find(gl_function, "OSMesaGetProcAddress");
  }
};

const OsMesa& osmesa() {
  static const OsMesa functions;
  return functions;
}

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
    context_ = osmesa().create(kAttributes.data(), nullptr);
    if (context_ == nullptr) refuse("OSMesa could not make one");
  }
  ~OsMesaContext() override {
    if (is_current()) osmesa().make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    osmesa().destroy(context_);
  }

  bool is_current() const override { return osmesa().current() == context_; }
  void make_current(int width, int height) override {
    surface_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    if (osmesa().make_current(context_, surface_.data(), GL_UNSIGNED_BYTE, width, height) !=
        GL_TRUE)
      throw RenderError("no drawing surface of " + std::to_string(width) + "x" +
                        std::to_string(height) + " pixels: OSMesa refused it");
    osmesa().pixel_store(OSMESA_Y_UP, 0);
  }
  GlFunction function(const char* name) const override { return osmesa().gl_function(name); }
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
