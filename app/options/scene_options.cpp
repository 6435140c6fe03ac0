#include "app/options/scene_options.h"

#include <CLI/CLI.hpp>

#include "app/options/number_range.h"

namespace quicksand {

void add_scene_options(CLI::App& command, SceneRequest& request) {
  command
      .add_option_function<std::string>(
          "scene", [&request](const std::string& word) { request.file = scene_named(word); },
          "path of a scene, or name of a shipped one")
      ->type_name("SCENE")
      ->required();
  command.option_defaults()->group("Scene");
  command
      .add_option("--set", request.overrides,
                  "change a value of the scene, e.g. step.dt=1e-3 or phases[1].force=2e4; null "
                  "removes a key, [+] appends to a list, e.g. phases[+]={\"type\":\"settle\"}; a "
                  "start_from is relative to the current folder; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", request.seed, "seed of the random numbers, instead of the scene's")
      ->type_name("N")
      ->check(whole_in_range(0, std::int64_t{1} << 53U));
  command.option_defaults()->group("Options");
}

}  // namespace quicksand
