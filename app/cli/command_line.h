// The whole program: reads the command line, runs the subcommand, turns errors into messages and exit
// codes.
#pragma once

#include <string>
#include <vector>

namespace quicksand {

int run_command_line(int argc, const char* const* argv);

// What is wrong with the words of a command line, the program's name left out; empty if they are
// accepted. Nothing is run.
std::string command_line_problem(const std::vector<std::string>& words);

}  // namespace quicksand
