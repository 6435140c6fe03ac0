// quicksand serve: the session in a browser, by hand.
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/error_message.h"
#include "app/commands/command_table.h"
#include "app/options/number_range.h"
#include "app/options/threads_option.h"
#include "app/serve/serve.h"
#include "core/base/parallel.h"

namespace quicksand {

Command add_serve(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "serve", "Watch and steer a simulation, or walk through a run, in a browser.");
  const auto options = std::make_shared<ServeOptions>();
  const auto threads = std::make_shared<std::int64_t>(0);
  constexpr int kLastPort = 65535;
  command
      ->add_option("file", options->file,
                   "scene (by name or path), folder of a run to walk through, or session to play "
                   "first; the demo if absent")
      ->type_name("SCENE|RUN|SESSION");
  command->add_flag("--open", options->open, "open the page in this machine's browser");
  command->add_option("--port", options->port, "port of the server; 0: any free one")
      ->type_name("N")
      ->check(whole_in_range(0, kLastPort))
      ->capture_default_str();
  command
      ->add_option(
          "--listen", options->address,
          "address to listen on; an address other than the default lets other machines connect")
      ->type_name("ADDRESS")
      ->capture_default_str();
  command
      ->add_option("--host", options->host,
                   "name by which browsers reach this machine, if not by its address")
      ->type_name("NAME");
  command
      ->add_option("--token-file", options->token_file,
                   "keep the token in this file, so that the address stays the same")
      ->type_name("FILE");
  command->add_flag("--pixels", options->pixels, "send pictures, for browsers without WebGL 2");
  command
      ->add_option(
          "--record", options->record,
          "write the actions done by hand as a session file that replays to the same state")
      ->type_name("FILE.json");
  command
      ->add_option("--out", options->out, "folder for the files offered for download [out/serve]")
      ->type_name("DIR");
  add_threads_option(*command, *threads, kThreadsOfOneRun);
  command->footer(
      "Prints the address with its token, and serves until Ctrl-C.\n\n"
      "Examples:\n  quicksand serve --open\n"
      "  quicksand serve collapse --record by_hand.json\n"
      "  quicksand serve out/collapse");
  return {command, [options, threads] {
            int code = 0;
            try {
              with_threads(thread_count(*threads), [&] { code = run_serve(*options); });
            } catch (const CommandFailure& failure) {
              return tell_failed({"session", failure.what()});
            }
            return code;
          }};
}

}  // namespace quicksand
