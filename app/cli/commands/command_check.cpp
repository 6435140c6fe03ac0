// quicksand check: validates a scene and says what will be modelled.
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/cli/commands.h"
#include "app/scene/scene_options.h"
#include "app/scene/scene_report.h"

namespace quicksand {

Command add_check(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("check", "Validate a scene and print what will be modelled.");
  const auto request = std::make_shared<SceneRequest>();
  add_scene_options(*command, *request);
  command->footer(
      "Examples:\n  quicksand check assets/scenes/collapse.json\n"
      "  quicksand check assets/scenes/paper_intruder.json --set contact.friction=0.6");
  return {command, [request] {
            std::fputs(scene_report(read_scene(*request)).c_str(), stdout);
            return kFine;
          }};
}

}  // namespace quicksand
