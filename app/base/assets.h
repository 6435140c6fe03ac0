// Where the files are that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

// The scene that app/run.sh and the window show when none is named.
constexpr const char* kDemoScene = "collapse";

// $QUICKSAND_ASSETS, else ../assets beside the program (a build in its source tree), else
// ../share/quicksand/assets (an installed program), else the source tree it was built from.
std::filesystem::path assets_folder();

// Sorted by name; empty if there is no such folder.
std::vector<std::filesystem::path> shipped_scenes();

// assets/scenes/NAME.json, relative to the working folder where that is shorter.
std::filesystem::path shipped_scene(const std::string& name);

}  // namespace quicksand
