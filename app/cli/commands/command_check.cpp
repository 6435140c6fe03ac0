// quicksand check: validates a scene and says what will be modelled.
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/cli/commands.h"
#include "app/options/scene_options.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_report.h"
#include "app/scene_json/scenario_json.h"
#include "core/scene/scenario.h"

namespace quicksand {

Command add_check(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("check", "Validate a scene and print what will be modelled.");
  const auto request = std::make_shared<SceneRequest>();
  const auto as_json = std::make_shared<bool>(false);
  add_scene_options(*command, *request);
  command->add_flag("--json", *as_json,
                    "print the scene with every default made explicit, as a run writes it");
  command->footer(
      "Examples:\n  quicksand check assets/scenes/collapse.json\n"
      "  quicksand check assets/scenes/paper_intruder.json --set contact.friction=0.6");
  return {command, [request, as_json] {
            const Scenario scenario = read_scene(*request);
            if (!scenario.start_from.empty()) start_world(scenario);  // throws where it cannot
            std::fputs((*as_json ? to_text(scenario) : scene_report(scenario)).c_str(), stdout);
            return kFine;
          }};
}

}  // namespace quicksand
