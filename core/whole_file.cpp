#include "core/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/errors.h"

namespace quicksand {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, int error) {
  throw InputError(path.string(), "cannot be written: " + std::string(std::strerror(error)));
}

}  // namespace

WholeFile::WholeFile(fs::path path) : path_(std::move(path)), part_(path_) {
  part_ += ".part";
  file_.open(part_, std::ios::binary | std::ios::trunc);
  if (!file_) refuse(path_, errno);
}

WholeFile::~WholeFile() {
  if (finished_) return;
  file_.close();
  std::error_code ignored;
  fs::remove(part_, ignored);
}

void WholeFile::finish() {
  file_.close();
  if (!file_) throw InputError(path_.string(), "cannot be written; is the disk full?");
  bring_to_disk(part_);
  std::error_code error;
  fs::rename(part_, path_, error);
  if (error) refuse(path_, error.value());
  finished_ = true;
  bring_to_disk(fs::absolute(path_).parent_path());
}

void write_whole(const fs::path& path, std::string_view text) {
  WholeFile file(path);
  file.stream() << text;
  file.finish();
}

void bring_to_disk(const fs::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) refuse(path, errno);
  // Some file systems cannot do this for a folder, and say so: then there is nothing to wait for.
  const bool done = fsync(file) == 0 || errno == EINVAL || errno == EROFS;
  const int error = errno;
  close(file);
  if (!done) refuse(path, error);
}

}  // namespace quicksand
