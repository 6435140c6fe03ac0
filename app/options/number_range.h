// A range that the value of an option must lie in, with the words that JSON files get for theirs.
#pragma once

#include <CLI/CLI.hpp>

#include "app/json/fields.h"

namespace quicksand {

// For `check`: "--slice: is 0, must be a number from 0.1 to 1e+06 d". Unlike CLI::Range it refuses nan, and octal
// and hexadecimal numbers, and can leave out the lower end.
CLI::Validator in_range(const Limits& limits);
// "--tolerance: is 1e1, must be a whole number from 0 to 255".
CLI::Validator whole_in_range(std::int64_t low, std::int64_t high);

}  // namespace quicksand
