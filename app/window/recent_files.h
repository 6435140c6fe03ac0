// What a person opened in windows before, kept between them: one path a line in quicksand/recent of the folder for states
// of programs (XDG_STATE_HOME, ~/.local/state).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/json/json_text.h"

namespace quicksand {

class RecentFiles {
 public:
  static constexpr std::size_t kMost = 10;

  // Where they are kept; empty if no home is known: then they are forgotten with the window.
  static std::filesystem::path usual_place();

  // What is not there any more is left out.
  explicit RecentFiles(std::filesystem::path file);

  const std::vector<std::string>& paths() const { return paths_; }  // absolute, the last first
  // Puts what a command opened in front, if it was a file or a run. Returns whether it was. That the list cannot be
  // written is no reason to complain.
  bool add(const Json& command);

 private:
  std::filesystem::path file_;
  std::vector<std::string> paths_;
};

}  // namespace quicksand
