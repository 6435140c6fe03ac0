// The options that name a scene and change it, the same for every command that reads one.
#pragma once

#include "app/scene/scene_file.h"

namespace CLI {
class App;
}

namespace quicksand {

void add_scene_options(CLI::App& command, SceneRequest& request);

}  // namespace quicksand
