// Text as a shell takes it for one word.
#pragma once

#include <filesystem>
#include <string>

namespace quicksand {

// In single quotes where a shell would read anything into it.
std::string shell_text(const std::filesystem::path& path);

// What the user types to call the program: $QUICKSAND_COMMAND, which app/run.sh sets to itself, else "quicksand".
std::string program_name();

}  // namespace quicksand
