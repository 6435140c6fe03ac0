#include "core/base/whole_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
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
  if (error == ENOSPC || error == EDQUOT || error == EFBIG) throw DiskFull(path.string(), problem);
  throw InputError(path.string(), problem);
}

OpenFile::~OpenFile() {
  if (number_ >= 0) ::close(number_);
}

namespace {

// Whoever else writes a file of this name is waited for. Its part may be renamed meanwhile, and then is another's.
OpenFile locked(const fs::path& part) {
  while (true) {
    OpenFile file(open(part.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
    if (file.number() < 0 || flock(file.number(), LOCK_EX) != 0) return file;
    struct stat held {
    }, there{};
    if (fstat(file.number(), &held) != 0) return file;
    if (stat(part.c_str(), &there) == 0 && held.st_ino == there.st_ino &&
        held.st_dev == there.st_dev)
      return file;
  }
}

}  // namespace

WholeFile::WholeFile(const fs::path& path) : path_(file_named(path)), part_(path_) {
  part_ += ".part";
  lock_ = locked(part_);
  file_.open(part_, std::ios::binary | std::ios::trunc);
  if (!file_) refuse_to_write(path_, errno);
}

WholeFile::~WholeFile() {
  if (finished_) return;
  file_.close();
  std::error_code ignored;
  fs::remove(part_, ignored);
}

void WholeFile::close() {
  file_.close();
  if (!file_) throw DiskFull(path_.string(), "cannot be written; is the disk full?");
}

void WholeFile::put_in_place() {
  std::error_code error;
  fs::rename(part_, path_, error);
  if (error) refuse_to_write(path_, error.value());
  finished_ = true;
}

void WholeFile::finish() {
  close();
  bring_to_disk(part_);
  put_in_place();
  bring_to_disk(fs::absolute(path_).parent_path());
}

void WholeFile::finish_soon() {
  close();
  put_in_place();
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
