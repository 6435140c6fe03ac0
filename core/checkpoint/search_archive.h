// The searches of a protocol in a checkpoint, without their base world.
#pragma once

#include "core/checkpoint/archive.h"
#include "core/phases/protocol.h"

namespace quicksand {

void write_search(CheckpointWriter& writer, const ProtocolState& state);
// Throws std::exception for what is no search.
void read_search(CheckpointReader& reader, ProtocolState& state);

}  // namespace quicksand
