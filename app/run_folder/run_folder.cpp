#include "app/run_folder/run_folder.h"

#include <fstream>
#include <string>
#include <vector>

#include "core/base/errors.h"

namespace quicksand {

namespace fs = std::filesystem;

bool holds_run(const RunFolder& folder) {
  return is_there(folder.scene()) && is_there(folder.options());
}

void make_writable(const RunFolder& folder) {
  if (is_there(folder.path) && !is_folder(folder.path)) {
    throw InputError(folder.path.string(),
                     "is a file, the results need a folder; choose another with --out");
  }
  std::error_code error;
  fs::create_directories(folder.path, error);
  if (error) {
    throw InputError(folder.path.string(), "cannot be made: " + error.message());
  }
  const fs::path probe = folder.path / ".quicksand_probe";
  const bool written = static_cast<bool>(std::ofstream(probe) << "writable");
  fs::remove(probe, error);
  if (!written) {
    throw InputError(folder.path.string(), "cannot be written; choose another folder with --out");
  }
}

void forget_end(const RunFolder& folder) {
  std::error_code ignored;
  fs::remove(folder.summary(), ignored);
}

void remove_earlier_results(const RunFolder& folder) {
  std::error_code ignored;
  for (const fs::path& file : {folder.state(), folder.summary(), folder.film(), folder.animation(),
                               folder.film_page(), folder.history(), folder.critical_forces(),
                               folder.adiabatic(), folder.report_page(), folder.report_text()}) {
    fs::remove(file, ignored);
  }
  std::vector<fs::path> frames;
  for (const auto& file : fs::directory_iterator(folder.frames(), ignored)) {
    const std::string name = file.path().filename().string();
    if (name.starts_with("frame_") && name.ends_with(".png")) frames.push_back(file.path());
  }
  for (const fs::path& frame : frames) fs::remove(frame, ignored);
}

}  // namespace quicksand
