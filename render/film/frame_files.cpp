#include "render/film/frame_files.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "core/base/format.h"
#include "render/film/sequence.h"

namespace quicksand {
namespace {

constexpr std::string_view kPrefix = "frame_";
constexpr std::string_view kSuffix = ".png";
constexpr std::size_t kDigits = 6;

// Number of frame_000012.png, -1 for any other name.
std::int64_t frame_number(const std::string& name) {
  if (name.size() < kPrefix.size() + kDigits + kSuffix.size()) return -1;
  if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) return -1;
  const std::string digits =
      name.substr(kPrefix.size(), name.size() - kPrefix.size() - kSuffix.size());
  const bool all_digits =
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  return all_digits && digits.size() <= 18 ? std::stoll(digits) : -1;
}

}  // namespace

std::filesystem::path frame_path(const std::filesystem::path& folder, std::int64_t number) {
  const std::string name = format("frame_%06lld.png", static_cast<long long>(number));
  return folder / name;
}

std::map<std::int64_t, std::filesystem::path> frame_files(const std::filesystem::path& folder) {
  std::map<std::int64_t, std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::int64_t number = frame_number(entry.path().filename().string());
    if (number >= 0) files.emplace(number, entry.path());
  }
  return files;
}

}  // namespace quicksand
