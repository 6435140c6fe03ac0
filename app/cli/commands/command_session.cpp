// quicksand session: plays a file of commands, or listens to commands on standard input.
#include <limits>
#include <memory>

#include "app/cli/commands.h"
#include "app/options/number_range.h"
#include "app/options/threads_option.h"
#include "app/play/play.h"
#include "core/base/parallel.h"

namespace quicksand {

Command add_session(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "session", "Play a file of commands, or read commands from standard input.");
  const auto options = std::make_shared<PlayOptions>();
  const auto threads = std::make_shared<std::int64_t>(0);
  command
      ->add_option("file", options->file,
                   "session file; - reads one command per line from standard input")
      ->type_name("FILE.json|-")
      ->required();
  command->add_option("--out", options->out, "folder for all files written [out/<session name>]")
      ->type_name("DIR");
  command->add_flag("--keep-going", options->keep_going,
                    "continue after a failed command, and list all failures at the end");
  command->add_option("--stop-after", options->stop_after, "stop after this many commands")
      ->type_name("N")
      ->check(whole_in_range(0, std::numeric_limits<int>::max()));
  add_threads_option(*command, *threads, kThreadsOfOneRun);
  command->add_flag("--quiet", options->quiet, "show no progress");
  command->footer(
      "For a file, DIR receives transcript.jsonl: each command with its result, time and the hash\n"
      "of the world. Exit code: 0, 1 if a command of the file failed (for standard input, the\n"
      "answer to the command says so), 2 if the file is malformed, 130 after Ctrl-C (the state is\n"
      "in interrupted.cbor). `quicksand list commands` lists the commands.\n\n"
      "Examples:\n"
      "  quicksand session assets/sessions/what_if.json\n"
      "  echo '{\"command\": \"load\", \"scene\": \"chain\"}' | quicksand session -");
  return {command, [options, threads] {
            int code = 0;
            with_threads(thread_count(*threads), [&] {
              code = options->file == "-" ? play_live(options->out) : play_session(*options);
            });
            return code;
          }};
}

}  // namespace quicksand
