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

// Whether another writer has the file by now, or has renamed it since it was opened here.
bool is_taken(const OpenFile& file, const fs::path& path) {
  if (flock(file.number(), LOCK_EX | LOCK_NB) != 0) return errno == EWOULDBLOCK;
  struct stat held {};
  struct stat there {};
  return fstat(file.number(), &held) == 0 &&
         (stat(path.c_str(), &there) != 0 || held.st_ino != there.st_ino ||
          held.st_dev != there.st_dev);
}

}  // namespace

WholeFile::WholeFile(const fs::path& path) : path_(file_named(path)) {
  // Two that write the same file at once have a part each; one that was killed leaves a part to the next.
  int tries = 0;
  do {
    part_ = path_;
    part_ += tries++ == 0 ? ".part" : ".part" + std::to_string(tries);
    lock_ = OpenFile(open(part_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
  } while (lock_.number() >= 0 && is_taken(lock_, part_));
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
