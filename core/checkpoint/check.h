// What no run can have written: the checks behind read_checkpoint, besides its checksum.
#pragma once

#include "core/checkpoint/checkpoint.h"

namespace quicksand {

// Null if the world and the protocol could be those of a run, otherwise what is wrong. The lists of
// bonds and contacts must be sorted and name bodies that exist.
const char* inconsistency(const Checkpoint& checkpoint);

}  // namespace quicksand
