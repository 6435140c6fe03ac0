// Text as a shell takes it for one word.
#pragma once

#include <filesystem>
#include <string>

namespace quicksand {

// In single quotes where a shell would read anything into it.
std::string shell_text(const std::filesystem::path& path);

}  // namespace quicksand
