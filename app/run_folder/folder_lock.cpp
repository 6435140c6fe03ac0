#include "app/run_folder/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"

namespace quicksand {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  make_writable({folder});
  file_ = open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  held_ = file_ < 0 || flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : file_(std::exchange(other.file_, -1)), held_(other.held_) {}

FolderLock::~FolderLock() {
  if (file_ >= 0) close(file_);
}

FolderLock lock_run(const std::filesystem::path& folder) {
  FolderLock lock(folder);
  if (!lock.held()) throw InputError(folder.string(), "another process is computing in it");
  return lock;
}

}  // namespace quicksand
