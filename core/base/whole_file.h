// A file that is there as a whole or not at all: written beside its place, brought to the disk, then
// renamed. Neither a killed program nor a power cut leaves half of it under its name.
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/base/errors.h"

namespace quicksand {

// There is no room for a result: nothing is wrong with the input, and the program ends with exit code 1.
class DiskFull : public InputError {
 public:
  using InputError::InputError;
};

// The file that a path names, links followed. Throws InputError if it is no file, but a pipe or a device: those
// cannot be replaced by one.
std::filesystem::path file_named(const std::filesystem::path& path);

// Throws what belongs to an error number: DiskFull, or an InputError.
[[noreturn]] void refuse_to_write(const std::filesystem::path& path, int error);

// The number of an open file or socket, closed with its owner; below 0: none.
class OpenFile {
 public:
  explicit OpenFile(int number = -1) : number_(number) {}
  ~OpenFile();
  OpenFile(OpenFile&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int number() const { return number_; }

 private:
  int number_;
};

class WholeFile {
 public:
  // Throws InputError if it cannot be written.
  explicit WholeFile(const std::filesystem::path& path);
  // Removes what was written if finish() was not reached.
  ~WholeFile();

  std::ostream& stream() { return file_; }
  // Puts the file in its place. Throws InputError if something could not be written.
  void finish();
  // The same without waiting for the disk: for many files that can be made again.
  void finish_soon();

 private:
  void close();
  void put_in_place();

  std::filesystem::path path_, part_;
  OpenFile lock_;  // of the part
  std::ofstream file_;
  bool finished_ = false;
};

// A whole file of this text. Throws InputError if it cannot be written.
void write_whole(const std::filesystem::path& path, std::string_view text);

// Throws InputError if no whole file could be written here, before there is something to write. Leaves what is there.
void try_to_write(const std::filesystem::path& path);

// Waits until what was written to a file, or the names in a folder, are on the disk. Throws InputError if
// they cannot be brought there.
void bring_to_disk(const std::filesystem::path& path);

}  // namespace quicksand
