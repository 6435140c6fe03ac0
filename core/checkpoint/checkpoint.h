// A world and the state of its protocol in one CBOR file, from which a run goes on bit by bit.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/protocol/protocol.h"
#include "core/world/world.h"

namespace quicksand {

struct Checkpoint {
  World world;
  ProtocolState protocol;
  std::string scene;  // the resolved scene as text; opaque here
  // Where the samples of a run stand; opaque here, empty if there is no run.
  std::vector<std::uint8_t> samples = {};
};

// A whole file: the old one stays until the new one is on the disk. Throws InputError if it cannot be
// written.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

// A whole checkpoint, but of another format version.
class OtherVersion : public InputError {
 public:
  using InputError::InputError;
};

// Throws InputError if the file is missing, truncated or damaged, OtherVersion if it is of another version,
// NotEnoughMemory if there is too little to read it.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace quicksand
