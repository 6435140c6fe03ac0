// Checkpoint files in a folder of their own, as bytes that a test can damage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace quicksand {

using Bytes = std::vector<std::uint8_t>;

// A new empty folder, removed with all its files at the end of the scope.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path file(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

Bytes read_bytes(const std::filesystem::path& path);
// The same checkpoint with another format version (below 24), and a checksum that fits.
Bytes with_version(Bytes bytes, std::uint8_t version);
void write_bytes(const std::filesystem::path& path, const Bytes& bytes);

}  // namespace quicksand
