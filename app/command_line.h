// The whole program: reads the command line, runs the subcommand, turns errors into messages and exit
// codes.
#pragma once

namespace quicksand {

int run_command_line(int argc, const char* const* argv);

}  // namespace quicksand
