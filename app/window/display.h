// A window on a screen: it shows pictures and tells what the user does. SDL lives behind it, in a module
// that is opened when a window is asked for: without one the program needs neither SDL nor X11.
#pragma once

#include <memory>
#include <string>

#include "app/gui/gui_input.h"
#include "render/image/image.h"

namespace quicksand {

class Display {
 public:
  virtual ~Display() = default;

  // Waits for something to happen, at most so long, and takes what did into `input`. False: the user
  // closed the window.
  virtual bool poll(GuiInput& input, int wait_milliseconds) = 0;
  // Whether poll() saw anything.
  virtual bool something_happened() const = 0;
  // Of the inside [px].
  virtual int width() const = 0;
  virtual int height() const = 0;
  // The picture should have the size of the window; where it has not, what is missing stays dark.
  virtual void present(const Image& picture) = 0;
};

// Throws RenderError that says what is missing: the module, SDL, or a screen.
std::unique_ptr<Display> open_display(const std::string& title, int width, int height);

// What the module exports: null and a reason if it cannot. The reason is the module's.
using OpenDisplay = Display* (*)(const char* title, int width, int height, const char** reason);
constexpr const char* kOpenDisplay = "quicksand_open_display";
constexpr const char* kDisplayModule = "quicksand_window.so";

}  // namespace quicksand
