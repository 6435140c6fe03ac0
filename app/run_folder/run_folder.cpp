#include "app/run_folder/run_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace fs = std::filesystem;

bool holds_run(const RunFolder& folder) {
  return is_there(folder.scene()) && is_there(folder.options());
}

void refuse_unreadable(const fs::path& file) {
  const auto refuse = [&](int problem) {
    throw InputError(file.string(), "cannot be read: " + std::string(std::strerror(problem)));
  };
  const OpenFile opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (opened.number() < 0) {
    if (errno != ENOENT && errno != ENOTDIR) refuse(errno);
    return;
  }
  std::vector<char> piece(std::size_t{1} << 16U);
  while (true) {
    const ssize_t got = ::read(opened.number(), piece.data(), piece.size());
    if (got == 0) return;
    if (got < 0 && errno != EINTR) refuse(errno);
  }
}

void refuse_special_files(const RunFolder& folder) {
  for (const fs::path& place : {folder.path, folder.frames()}) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(place, ignored))
      if (entry.exists(ignored) && !entry.is_regular_file(ignored) && !entry.is_directory(ignored))
        throw InputError(entry.path().string(), "is neither a file nor a folder; remove it");
  }
}

void make_writable(const RunFolder& folder) {
  if (is_there(folder.path) && !is_folder(folder.path)) {
    throw InputError(folder.path.string(),
                     "is a file, but the results need a folder; choose another with --out");
  }
  std::error_code error;
  fs::create_directories(folder.path, error);
  if (error) {
    throw InputError(folder.path.string(), "cannot be created: " + error.message());
  }
  const fs::path probe = folder.path / ".quicksand_probe";
  errno = 0;
  const bool written = static_cast<bool>(std::ofstream(probe) << "writable" << std::flush);
  const int problem = errno;
  fs::remove(probe, error);
  if (written) return;
  if (problem == ENOSPC || problem == EDQUOT) refuse_to_write(folder.path, problem);
  throw InputError(folder.path.string(), "cannot be written; choose another folder with --out");
}

void forget_end(const RunFolder& folder) {
  std::error_code ignored;
  fs::remove(folder.summary(), ignored);
}

void remove_earlier_results(const RunFolder& folder) {
  std::error_code ignored;
  for (const fs::path& file :
       {folder.state(), folder.summary(), folder.film(), folder.animation(), folder.film_page(),
        folder.history(), folder.critical_forces(), folder.adiabatic(), folder.computing_time(),
        folder.report_page(), folder.report_text()}) {
    fs::remove(file, ignored);
  }
  std::vector<fs::path> frames;
  for (const auto& file : fs::directory_iterator(folder.frames(), ignored)) {
    const std::string name = file.path().filename().string();
    if (name.starts_with("frame_") && name.ends_with(".png")) frames.push_back(file.path());
  }
  for (const fs::path& frame : frames) fs::remove(frame, ignored);
}

bool leads_into(const fs::path& folder, const fs::path& path) {
  // Empty if it cannot be told, as where the working folder has been removed.
  const auto canonical = [](const fs::path& name) {
    std::error_code error;
    const fs::path absolute = fs::absolute(name, error);
    fs::path found = error ? fs::path() : fs::weakly_canonical(absolute, error);
    return error ? fs::path() : found;
  };
  fs::path home = canonical(folder);
  if (!home.has_filename()) home = home.parent_path();  // a slash at the end
  const fs::path there = canonical(path);
  if (home.empty() || there.empty()) return false;
  std::error_code error;
  const auto [home_end, rest] = std::mismatch(home.begin(), home.end(), there.begin(), there.end());
  if (home_end != home.end()) return false;
  // What is not there is not followed, so that a link to nothing is still among the names.
  fs::path at = home;
  return std::none_of(rest, there.end(), [&](const fs::path& name) {
    at /= name;
    return fs::is_symlink(fs::symlink_status(at, error));
  });
}

bool all_lead_into(const fs::path& folder, const fs::path& path) {
  if (!leads_into(folder, path)) return false;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(path, error);
       !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
    if (entry->is_symlink(error) && !leads_into(folder, entry->path())) return false;
  return true;
}

}  // namespace quicksand
