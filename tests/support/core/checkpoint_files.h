// Checkpoint files as bytes that a test can damage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace quicksand {

using Bytes = std::vector<std::uint8_t>;

Bytes read_bytes(const std::filesystem::path& path);
// The same checkpoint with another format version (below 24), and a checksum that fits.
Bytes with_version(Bytes bytes, std::uint8_t version);
// The same bytes, the last nine of them replaced by their seal.
Bytes with_fitting_checksum(Bytes bytes);
void write_bytes(const std::filesystem::path& path, const Bytes& bytes);

}  // namespace quicksand
