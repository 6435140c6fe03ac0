// A world and the state of its protocol in one CBOR file, from which a run goes on bit by bit.
#pragma once

#include <filesystem>
#include <string>

#include "core/protocols.h"
#include "core/world.h"

namespace quicksand {

struct Checkpoint {
  World world;
  ProtocolState protocol;
  std::string scene;  // the resolved scene as text; opaque here
};

// Writes to a temporary name beside `path`, then renames. Throws InputError if it cannot be written.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

// Throws InputError if the file is missing, truncated, damaged or of another version.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace quicksand
