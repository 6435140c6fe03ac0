#include "app/run_folder/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>

#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"

namespace quicksand {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  make_writable({folder});
  file_ = OpenFile(open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  held_ =
      file_.number() < 0 || flock(file_.number(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

FolderLock lock_run(const std::filesystem::path& folder) {
  FolderLock lock(folder);
  if (!lock.held()) throw InputError(folder.string(), "another process is computing in it");
  return lock;
}

}  // namespace quicksand
