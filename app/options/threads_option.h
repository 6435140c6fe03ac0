// How many threads a command uses: shared between its runs, or all for its one run.
#pragma once

#include <cstdint>

#include "app/options/cli_app.h"

namespace quicksand {

// `--threads N`, from 1; left at 0 where it is not named. `meaning`: what the help says of it.
void add_threads_option(CLI::App& command, std::int64_t& threads, const char* meaning);

inline constexpr const char* kThreadsOfOneRun =
    "threads for the contact solver, used from a few thousand contacts on; the results are the "
    "same";

inline constexpr const char* kThreadsOfRuns =
    "runs computed at the same time; once half as many are left, free threads help to solve their "
    "contacts";

// `asked`, or all cores of the machine if that is 0.
int thread_count(std::int64_t asked);

}  // namespace quicksand
