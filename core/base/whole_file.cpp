#include "core/base/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/base/errors.h"

namespace quicksand {

namespace fs = std::filesystem;

fs::path file_named(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status there = fs::status(path, ignored);
  if (!fs::exists(there)) return path;
  if (!fs::is_regular_file(there))
    throw InputError(path.string(),
                     "is not a regular file, so a result cannot replace it; choose another");
  return fs::is_symlink(fs::symlink_status(path, ignored)) ? fs::canonical(path) : path;
}

void refuse_to_write(const fs::path& path, int error) {
  const std::string problem = "cannot be written: " + std::string(std::strerror(error));
  if (error == ENOSPC || error == EDQUOT) throw DiskFull(path.string(), problem);
  throw InputError(path.string(), problem);
}

OpenFile::~OpenFile() {
  if (number_ >= 0) close(number_);
}

WholeFile::WholeFile(const fs::path& path) : path_(file_named(path)), part_(path_) {
  part_ += ".part";
  file_.open(part_, std::ios::binary | std::ios::trunc);
  if (!file_) refuse_to_write(path_, errno);
}

WholeFile::~WholeFile() {
  if (finished_) return;
  file_.close();
  std::error_code ignored;
  fs::remove(part_, ignored);
}

void WholeFile::finish() {
  file_.close();
  if (!file_) throw DiskFull(path_.string(), "cannot be written; is the disk full?");
  bring_to_disk(part_);
  std::error_code error;
  fs::rename(part_, path_, error);
  if (error) refuse_to_write(path_, error.value());
  finished_ = true;
  bring_to_disk(fs::absolute(path_).parent_path());
}

void write_whole(const fs::path& path, std::string_view text) {
  WholeFile file(path);
  file.stream() << text;
  file.finish();
}

void try_to_write(const fs::path& path) { const WholeFile tried(path); }

void bring_to_disk(const fs::path& path) {
  const OpenFile file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) refuse_to_write(path, errno);
  // Some file systems cannot do this for a folder, and say so: then there is nothing to wait for.
  if (fsync(file.number()) != 0 && errno != EINVAL && errno != EROFS) refuse_to_write(path, errno);
}

}  // namespace quicksand
