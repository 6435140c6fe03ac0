// The subcommands. Each adds itself to the command line and, if it was called, runs and returns the
// exit code; bad input leaves as InputError.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace quicksand {

// What to run when the command line names this command.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;
};

Command add_run(CLI::App& program);
Command add_resume(CLI::App& program);
Command add_check(CLI::App& program);
Command add_render(CLI::App& program);
Command add_report(CLI::App& program);
Command add_campaign(CLI::App& program);
Command add_measure(CLI::App& program);
Command add_export(CLI::App& program);
Command add_reproduce(CLI::App& program);
Command add_bench(CLI::App& program);
Command add_session(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_window(CLI::App& program);
Command add_serve(CLI::App& program);
Command add_list(CLI::App& program);

}  // namespace quicksand
