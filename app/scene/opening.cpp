#include "app/scene/opening.h"

#include <algorithm>

#include "app/base/assets.h"
#include "app/run_folder/run_folder.h"
#include "app/scene/scene_file.h"

namespace quicksand {

namespace fs = std::filesystem;

namespace {

bool is_run(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(RunFolder{folder}.history(), ignored);
}

}  // namespace

Json opening_command(const std::string& named) {
  if (named.empty()) return {{"command", "load"}, {"scene", kDemoScene}};
  std::error_code ignored;
  const std::string path = fs::absolute(named).lexically_normal().string();
  if (fs::is_directory(named, ignored)) return {{"command", "open"}, {"run", path}};
  const bool is_file = named.find_first_of("/.") != std::string::npos;
  if (!is_file) return {{"command", "load"}, {"scene", named}};
  if (fs::path(named).extension() == ".cbor") return {{"command", "restore"}, {"file", path}};
  if (parse_json(read_scene_text(named)).contains("commands"))
    return {{"command", "include"}, {"file", path}};
  return {{"command", "load"}, {"scene", path}};
}

std::vector<std::string> openable_in(const fs::path& folder, std::size_t most) {
  std::vector<std::string> folders, files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (name.starts_with('.')) continue;
    if (entry->is_directory(ignored) && !is_run(entry->path())) {
      folders.push_back(name + "/");
    } else if (entry->is_directory(ignored) || name.ends_with(".json") || name.ends_with(".cbor")) {
      files.push_back(name);
    }
  }
  std::ranges::sort(folders);
  std::ranges::sort(files);
  std::vector<std::string> all;
  if (folder.has_parent_path() && folder != folder.root_path()) all.emplace_back("../");
  all.insert(all.end(), folders.begin(), folders.end());
  all.insert(all.end(), files.begin(), files.end());
  all.resize(std::min(all.size(), most));
  return all;
}

}  // namespace quicksand
