// What the shell can know of the program, from the commands and options of its command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace quicksand {

// The manual page, section 1, for man(1).
std::string man_page(const CLI::App& program);

// A script that lets bash complete commands, options and, where neither fits, files.
std::string bash_completion(const CLI::App& program);

}  // namespace quicksand
