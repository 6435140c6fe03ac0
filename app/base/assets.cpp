#include "app/base/assets.h"

#include <algorithm>
#include <cstdlib>

namespace quicksand {

namespace fs = std::filesystem;

fs::path assets_folder() {
  if (const char* chosen = std::getenv("QUICKSAND_ASSETS"); chosen != nullptr && *chosen != '\0') {
    return chosen;
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path prefix = program.parent_path().parent_path();
    for (const char* place : {"assets", "share/quicksand/assets"}) {
      fs::path folder = prefix / place;
      if (fs::is_directory(folder / "scenes", error)) return folder;
    }
  }
  return QUICKSAND_SOURCE_ASSETS;
}

std::vector<fs::path> shipped_scenes() {
  std::vector<fs::path> scenes;
  std::error_code error;
  for (const auto& file : fs::directory_iterator(assets_folder() / "scenes", error)) {
    if (file.path().extension() == ".json") scenes.push_back(file.path());
  }
  std::ranges::sort(scenes);
  return scenes;
}

fs::path shipped_scene(const std::string& name) {
  const fs::path path = assets_folder() / "scenes" / (name + ".json");
  std::error_code error;
  const fs::path relative = fs::relative(path, error);
  return !error && relative.native().size() < path.native().size() ? relative : path;
}

}  // namespace quicksand
