#include "render/film/sequence.h"

#include <system_error>

#include "core/base/errors.h"
#include "render/film/frame_files.h"
#include "render/image/png.h"

namespace quicksand {
namespace {

using Frame = std::pair<std::int64_t, Image>;

constexpr std::size_t kLongestQueue = 4;  // pictures in memory

void make_frame_folder(const std::filesystem::path& folder, std::int64_t first) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw InputError(folder.string(), "cannot be made a folder for frames" +
                                          (error ? ": " + error.message() : std::string()));
  }
  for (const auto& [number, path] : frame_files(folder)) {
    if (number < first) continue;
    std::filesystem::remove(path, error);
    if (error) throw InputError(path.string(), "cannot be replaced: " + error.message());
  }
}

}  // namespace

Sequence::Sequence(const std::filesystem::path& folder, std::int64_t first)
    : next_(first), writer_(kLongestQueue, [folder, first] {
        make_frame_folder(folder, first);
        return [folder](const Frame& frame) {
          write_png(frame_path(folder, frame.first), frame.second);
        };
      }) {}

}  // namespace quicksand
