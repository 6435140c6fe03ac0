#include "app/scene/opening.h"

#include <algorithm>

#include "app/base/assets.h"
#include "app/run_folder/run_folder.h"
#include "app/scene/scene_file.h"

namespace quicksand {

namespace fs = std::filesystem;

namespace {

bool is_run(const fs::path& folder) { return is_there(RunFolder{folder}.history()); }

}  // namespace

Json opening_command(const std::string& named) {
  if (named.empty()) return {{"command", "load"}, {"scene", kDemoScene}};
  const std::string path = fs::absolute(named).lexically_normal().string();
  if (is_folder(named)) return {{"command", "open"}, {"run", path}};
  const bool is_file = named.find_first_of("/.") != std::string::npos;
  if (!is_file) return {{"command", "load"}, {"scene", named}};
  if (fs::path(named).extension() == ".cbor") return {{"command", "restore"}, {"file", path}};
  const std::string text = read_scene_text(named);
  if (in_file(named, [&] { return parse_json(text); }).contains("commands"))
    return {{"command", "include"}, {"file", path}};
  return {{"command", "load"}, {"scene", path}};
}

std::vector<std::string> openable_in(const fs::path& folder, std::size_t most) {
  std::vector<std::string> folders, files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.')) continue;
    const bool is_below = is_folder(entry->path());
    if (is_below && !is_run(entry->path())) {
      folders.push_back(name + "/");
    } else if (is_below || name.ends_with(".json") || name.ends_with(".cbor")) {
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
