#include "app/web/page_files.h"

#include <array>
#include <filesystem>
#include <utility>

#include "app/base/assets.h"
#include "app/json/json_text.h"
#include "core/base/errors.h"

namespace quicksand {

namespace fs = std::filesystem;

std::string content_type(const std::string& name) {
  constexpr auto kTypes = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{".html", "text/html; charset=utf-8"},
       {".css", "text/css; charset=utf-8"},
       {".js", "text/javascript; charset=utf-8"},
       {".json", "application/json"},
       {".svg", "image/svg+xml"},
       {".png", "image/png"},
       {".csv", "text/csv; charset=utf-8"},
       {".mp4", "video/mp4"},
       {".ttf", "font/ttf"}});
  for (const auto& [end, type] : kTypes)
    if (name.ends_with(end)) return std::string(type);
  return "application/octet-stream";
}

PageParts page_files() {
  const fs::path folder = assets_folder() / "web";
  PageParts parts;
  std::error_code error;
  for (const auto& file : fs::directory_iterator(folder, error)) {
    if (!file.is_regular_file(error)) continue;
    const std::string name = file.path().filename().string();
    parts["/" + name] = {content_type(name),
                         std::make_shared<const std::string>(read_text(file.path()))};
  }
  const auto page = parts.find("/index.html");
  if (page == parts.end())
    throw InputError(folder.string(), "has no index.html; QUICKSAND_ASSETS names the folder above");
  parts["/"] = page->second;
  return parts;
}

}  // namespace quicksand
