// Keeps two processes from computing in the same folder. The system releases the lock with the process,
// however it ends.
#pragma once

#include <filesystem>

#include "core/base/whole_file.h"

namespace quicksand {

class FolderLock {
 public:
  // Makes the folder where it is absent. Throws InputError if that is not possible.
  explicit FolderLock(const std::filesystem::path& folder);

  // False: another process has it. File systems that know no locks give it to all.
  bool held() const { return held_; }

 private:
  OpenFile file_;
  bool held_ = false;
};

// Whether another process computes in the folder. Makes nothing; for the moment of the question the lock is taken.
bool is_computed_elsewhere(const std::filesystem::path& folder);

// The lock of a run's folder. Throws InputError if another process computes in it.
FolderLock lock_run(const std::filesystem::path& folder);

}  // namespace quicksand
