// quicksand window: the panel in a window, by hand.
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/error_message.h"
#include "app/commands/command_table.h"
#include "app/options/picture_options.h"
#include "app/window/window.h"

namespace quicksand {

Command add_window(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("window", "Watch and steer a simulation in a window (needs SDL2).");
  const auto options = std::make_shared<WindowOptions>();
  const auto size = std::make_shared<std::string>("1280x720");
  command
      ->add_option(
          "file", options->file,
          "scene (by name or path), folder of a run to walk through (finished or still running), "
          "saved state, or session to play before the window opens; the demo if absent")
      ->type_name("SCENE|DIR|STATE|SESSION");
  command
      ->add_option(
          "--record", options->record,
          "write the actions done by hand as a session file that replays to the same state")
      ->type_name("FILE.json");
  command->add_option("--out", options->out, "folder for states and recordings [out/window]")
      ->type_name("DIR");
  command->add_option("--scale", options->scale, "scale of text and controls, 0.5 to 4")
      ->type_name("NUMBER")
      ->capture_default_str();
  command->add_option("--size", *size, "size of the window in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command->footer(
      "Examples:\n"
      "  quicksand window out/collapse\n"
      "  quicksand window collapse --record by_hand.json");
  return {command, [options, size] {
            read_size(*size, options->width, options->height);
            try {
              return run_window(*options);
            } catch (const CommandFailure& failure) {
              return tell_failed({"session", failure.what()});
            }
          }};
}

}  // namespace quicksand
