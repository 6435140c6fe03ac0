// A checkpoint as the commands that look at a state need it: with the scene that it is of.
#pragma once

#include <filesystem>
#include <string>

#include "core/checkpoint/checkpoint.h"
#include "core/scene/scenario.h"

namespace quicksand {

struct StateFile {
  Checkpoint checkpoint;
  Scenario scenario;
  std::string phase;  // name of the one that the state is in; "end" after the last
};

// Throws InputError if the path of a state is that of a folder, such as that of a run, in which it is a file.
void refuse_folder(const std::filesystem::path& state);

// Throws InputError if it is no checkpoint or holds a scene that this version cannot read.
StateFile read_state(const std::filesystem::path& path);

}  // namespace quicksand
