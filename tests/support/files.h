// What is in files, and where the source tree is.
#pragma once

#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.h"

namespace quicksand::test {

// The source tree that is tested.
inline const std::filesystem::path kSource = QUICKSAND_SOURCE;

// The whole file; empty if there is none.
std::string contents(const std::filesystem::path& file);

}  // namespace quicksand::test
