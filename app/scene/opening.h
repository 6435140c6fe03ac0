// What a path stands for that someone wants to see: a scene, a session file, a saved state, a run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/json/json_text.h"

namespace quicksand {

// The command that shows it: a shipped scene by its name, a file, or the folder of a run; the demo if empty. Throws
// InputError.
Json opening_command(const std::string& named);

// Names in a folder that opening_command() takes, sorted, folders to go on from first and with a slash at their ends: "../",
// "out/", "my_scene.json". Hidden ones and all beyond the first `most` are left out; none where the folder cannot be read.
std::vector<std::string> openable_in(const std::filesystem::path& folder, std::size_t most = 500);

}  // namespace quicksand
