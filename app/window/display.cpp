#include "app/window/display.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "render/base/render_error.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

// Beside the program, or where an installation puts it.
fs::path module_path() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path beside = program / kDisplayModule;
  return fs::exists(beside, error) ? beside : program / "../lib/quicksand" / kDisplayModule;
}

bool has(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

std::unique_ptr<Display> open_display(const std::string& title, int width, int height) {
  // SDL would silently draw nowhere.
  if (!has("DISPLAY") && !has("WAYLAND_DISPLAY"))
    throw RenderError(
        "there is no screen: neither DISPLAY nor WAYLAND_DISPLAY is set; `quicksand session` works "
        "without one");
  const fs::path path = module_path();
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw RenderError("the program was built without " + std::string(kDisplayModule) +
                      "; install libsdl2-dev and build again (`app/run.sh window` does both)");
  // Stays open until the program ends: what it made lives on in the display.
  void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr)
    throw RenderError(
        std::string("the module for windows cannot be opened (is libsdl2-2.0-0 installed?): ") +
        dlerror());
  const auto open = reinterpret_cast<OpenDisplay>(dlsym(module, kOpenDisplay));
  if (open == nullptr)
    throw RenderError(path.string() + " does not belong to this program: it lacks " + kOpenDisplay);
  const char* reason = "unknown";
  std::unique_ptr<Display> display(open(title.c_str(), width, height, &reason));
  if (!display) throw RenderError(std::string("SDL cannot open a window: ") + reason);
  return display;
}

}  // namespace quicksand
