// A file that is there as a whole or not at all: written beside its place, then renamed.
#pragma once

#include <filesystem>
#include <fstream>

namespace quicksand {

class WholeFile {
 public:
  // Throws InputError if it cannot be written.
  explicit WholeFile(std::filesystem::path path);
  // Removes what was written if finish() was not reached.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  std::ostream& stream() { return file_; }
  // Puts the file in its place. Throws InputError if something could not be written.
  void finish();

 private:
  std::filesystem::path path_, part_;
  std::ofstream file_;
  bool finished_ = false;
};

}  // namespace quicksand
