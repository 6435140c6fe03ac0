#include "app/run_folder/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>

#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

OpenFile lock_file(const std::filesystem::path& folder, int flags) {
  return OpenFile(open((folder / ".lock").c_str(), O_RDWR | O_CLOEXEC | flags, 0666));
}

bool take(const OpenFile& file) {
  return file.number() < 0 || flock(file.number(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) {
  make_writable({folder});
  file_ = lock_file(folder, O_CREAT);
  held_ = take(file_);
}

bool is_computed_elsewhere(const std::filesystem::path& folder) {
  return !take(lock_file(folder, 0));
}

FolderLock lock_run(const std::filesystem::path& folder) {
  FolderLock lock(folder);
  if (!lock.held())
    throw InputError(folder.string(),
                     "another process is computing in it; choose another folder with --out");
  return lock;
}

}  // namespace quicksand
