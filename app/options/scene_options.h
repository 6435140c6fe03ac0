// The options that name a scene and change it, the same for every command that reads one.
#pragma once

#include "app/options/cli_app.h"
#include "app/scene/scene_file.h"

namespace quicksand {

void add_scene_options(CLI::App& command, SceneRequest& request);

}  // namespace quicksand
