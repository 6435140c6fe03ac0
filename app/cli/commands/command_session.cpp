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
      "session", "Play a file of commands, or take commands from standard input.");
  const auto options = std::make_shared<PlayOptions>();
  const auto threads = std::make_shared<std::int64_t>(0);
  command
      ->add_option("file", options->file,
                   "session file; - takes a command a line from standard input")
      ->type_name("FILE.json|-")
      ->required();
  command->add_option("--out", options->out, "folder that receives every file [out/<session name>]")
      ->type_name("DIR");
  command->add_flag("--keep-going", options->keep_going,
                    "go on after a command failed, and list all failures at the end");
  command->add_option("--stop-after", options->stop_after, "stop after so many commands")
      ->type_name("N")
      ->check(whole_in_range(0, std::numeric_limits<int>::max()));
  add_threads_option(*command, *threads, kThreadsOfOneRun);
  command->add_flag("--quiet", options->quiet, "show no progress");
  command->footer(
      "Of a file, DIR receives transcript.jsonl: each command with its result, time and the hash "
      "of\n"
      "the world. Exit code: 0, 1 if a command of the file failed (answers to standard input say "
      "it\n"
      "themselves), 2 if the file is malformed, 130 after Ctrl-C (the state is in "
      "interrupted.cbor).\n"
      "`quicksand list commands` tells what there is to say.\n\n"
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
