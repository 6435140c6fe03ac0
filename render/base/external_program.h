// Runs another program, such as ffmpeg, gnuplot or sbatch, to its end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

struct ProgramEnd {
  int code = -1;         // exit code, 128 + signal if it was killed; -1 if it never ran
  bool missing = false;  // there is no such program
  std::string answer;    // what it wrote to standard output, up to 4 KiB
  std::string problem;   // why it did not end with 0, with what it wrote; else empty

  bool fine() const { return code == 0; }
};

// Runs words[0], looked up in PATH, with the other words as its arguments; no shell reads them. It
// starts in `folder` with no input, and waits for the end.
ProgramEnd run_external(std::vector<std::string> words, const std::filesystem::path& folder = ".");

// A file name for programs that read a percent sign in it as the start of a number.
std::string escaped_percent(const std::string& name);

}  // namespace quicksand
