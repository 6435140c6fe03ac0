#include "app/window/first_command.h"

#include <filesystem>

#include "app/base/assets.h"
#include "app/scene/scene_file.h"

namespace quicksand {

Json first_command(const std::string& file) {
  if (file.empty()) return {{"command", "load"}, {"scene", kDemoScene}};
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    return {{"command", "open"}, {"run", std::filesystem::absolute(file).string()}};
  const bool is_file = file.find_first_of("/.") != std::string::npos;
  if (!is_file) return {{"command", "load"}, {"scene", file}};
  const std::string path = std::filesystem::absolute(file).string();
  if (parse_json(read_scene_text(file)).contains("commands"))
    return {{"command", "include"}, {"file", path}};
  return {{"command", "load"}, {"scene", path}};
}

}  // namespace quicksand
