// The session in a window: the same panel and the same commands, by hand.
#pragma once

#include <filesystem>
#include <string>

namespace quicksand {

struct WindowOptions {
  std::string file;  // a scene, by name or path, or a session that is played first; empty: the demo
  std::filesystem::path out;     // empty: out/window
  std::filesystem::path record;  // receives what was done, as a session file; empty: none
  double scale = 1;
  int width = 1280, height = 720;  // [px]
};

// Returns the exit code when the window is closed. Throws InputError, RenderError.
int run_window(const WindowOptions& options);

}  // namespace quicksand
