#include "app/window/recent_files.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "core/base/whole_file.h"

namespace quicksand {

namespace fs = std::filesystem;

namespace {

// The file or folder that a command opens; empty if it opens none.
std::string opened_by(const Json& command) {
  constexpr auto kArguments = std::to_array<std::pair<const char*, const char*>>(
      {{"load", "scene"}, {"restore", "file"}, {"include", "file"}, {"open", "run"}});
  for (const auto& [name, argument] : kArguments) {
    if (command.at("command") != name || !command.contains(argument)) continue;
    const Json& path = command[argument];
    return path.is_string() && fs::path(path.get<std::string>()).is_absolute()
               ? path.get<std::string>()
               : std::string();
  }
  return {};
}

}  // namespace

fs::path RecentFiles::usual_place() {
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    return fs::path(value == nullptr ? "" : value);
  };
  if (const fs::path states = folder("XDG_STATE_HOME"); states.is_absolute())
    return states / "quicksand" / "recent";
  const fs::path home = folder("HOME");
  return home.is_absolute() ? home / ".local" / "state" / "quicksand" / "recent" : fs::path();
}

RecentFiles::RecentFiles(fs::path file) : file_(std::move(file)) {
  constexpr std::size_t kLongest = 4096;  // path of Linux
  std::ifstream lines(file_);
  std::array<char, kLongest> line{};
  while (paths_.size() < kMost && lines.getline(line.data(), line.size())) {
    std::error_code ignored;
    if (fs::path(line.data()).is_absolute() && fs::exists(line.data(), ignored))
      paths_.emplace_back(line.data());
  }
}

bool RecentFiles::add(const Json& command) {
  const std::string path = opened_by(command);
  if (path.empty()) return false;
  std::erase(paths_, path);
  paths_.insert(paths_.begin(), path);
  if (paths_.size() > kMost) paths_.pop_back();
  if (file_.empty()) return true;
  std::string text;
  for (const std::string& kept : paths_) text += kept + "\n";
  try {
    fs::create_directories(file_.parent_path());
    write_whole(file_, text);
  } catch (const fs::filesystem_error&) {
  } catch (const InputError&) {
  }
  return true;
}

}  // namespace quicksand
