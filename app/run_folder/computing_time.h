// How long a run has computed, all its parts together. While it has no summary this is kept in a file of its own: the
// bytes of its state are those of a run that was never interrupted.
#pragma once

#include "app/run_folder/run_folder.h"

namespace quicksand {

// As the summary says, or up to the last checkpoint; 0 if neither is there [s].
double computing_time_of(const RunFolder& folder);

// Throws InputError if it cannot be written.
void keep_computing_time(const RunFolder& folder, double seconds);

// Once the summary has it.
void forget_computing_time(const RunFolder& folder);

}  // namespace quicksand
