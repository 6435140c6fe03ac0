// Records contact problems of a run: of each phase so many, evenly over all that are posed in it, those of the bond
// failure criterion included.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run/progress_line.h"
#include "app/scene/scene_file.h"

namespace quicksand::bench {

struct RecordRequest {
  SceneRequest scene;
  std::filesystem::path out = "out/problems";
  int count = 100;  // of each phase
  ProgressLine::Style progress = ProgressLine::Style::none;
};

struct Recording {
  int problems = 0;  // written
  bool interrupted = false;
  std::string failure;  // a sentence, if the run failed
};

// The files of a folder and of the folders in it that hold problems, in the order of each run.
std::vector<std::filesystem::path> problems_in(const std::filesystem::path& folder);

// Runs the scene and writes its problems, each with a reference solution, as out/*.problem. Ctrl-C ends the run, and
// what the phase under way has posed is written. Makes the folder. Throws InputError where it holds problems already, or
// cannot be written.
Recording record_problems(const RecordRequest& request);

}  // namespace quicksand::bench
