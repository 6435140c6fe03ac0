#include "app/run/whole_file.h"

#include "core/errors.h"

namespace quicksand {

namespace fs = std::filesystem;

WholeFile::WholeFile(fs::path path) : path_(std::move(path)), part_(path_) {
  part_ += ".part";
  file_.open(part_, std::ios::binary | std::ios::trunc);
  if (!file_) throw InputError(path_.string(), "cannot be written");
}

WholeFile::~WholeFile() {
  if (finished_) return;
  file_.close();
  std::error_code ignored;
  fs::remove(part_, ignored);
}

void WholeFile::finish() {
  file_.close();
  std::error_code error;
  if (file_) fs::rename(part_, path_, error);
  if (!file_ || error) throw InputError(path_.string(), "cannot be written; is the disk full?");
  finished_ = true;
}

}  // namespace quicksand
