// The names of the frames of a film.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>

namespace quicksand {

// The frames in a folder by number; other files are passed over. Empty if there is no folder.
std::map<std::int64_t, std::filesystem::path> frame_files(const std::filesystem::path& folder);

}  // namespace quicksand
