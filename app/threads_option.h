// How many runs a command computes at the same time.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace quicksand {

// `--threads N`, from 1; left at 0 where it is not named.
void add_threads_option(CLI::App& command, std::int64_t& threads);

// `asked`, or all cores of the machine if that is 0.
int thread_count(std::int64_t asked);

}  // namespace quicksand
