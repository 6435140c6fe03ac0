// Runs another program, such as ffmpeg or gnuplot, to its end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

struct ProgramEnd {
  int code = -1;         // exit code, 128 + signal if it was killed; -1 if it never ran
  bool missing = false;  // there is no such program
  std::string problem;   // why it did not end with 0, with its messages; else empty

  bool fine() const { return code == 0; }
};

// Runs words[0], looked up in PATH, with the other words as its arguments; no shell reads them. It
// starts in `folder` with no input, and waits for the end. Messages of both outputs are collected.
ProgramEnd run_external(std::vector<std::string> words, const std::filesystem::path& folder = ".");

}  // namespace quicksand
