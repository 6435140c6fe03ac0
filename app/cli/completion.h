// What bash can know of the program, from the commands and options of its command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace quicksand {

// A script that lets bash complete commands, options and, where neither fits, files.
std::string bash_completion(const CLI::App& program);

}  // namespace quicksand
