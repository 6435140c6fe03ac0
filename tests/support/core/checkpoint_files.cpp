#include "tests/support/core/checkpoint_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace quicksand {

Bytes read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Bytes with_version(Bytes bytes, std::uint8_t version) {
  constexpr std::string_view kKey = "version";
  const auto key = std::search(bytes.begin(), bytes.end(), kKey.begin(), kKey.end());
  if (key == bytes.end()) throw std::runtime_error("no version in this checkpoint");
  key[kKey.size()] = version;  // small numbers are one byte in CBOR
  return with_fitting_checksum(std::move(bytes));
}

Bytes with_fitting_checksum(Bytes bytes) {
  // FNV-1a of all but the seal: the head of a string of eight bytes, then the hash, low byte first.
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (std::size_t k = 0; k + 9 < bytes.size(); ++k) hash = (hash ^ bytes[k]) * 0x100000001B3ULL;
  bytes[bytes.size() - 9] = 0x48;
  for (std::size_t k = 0; k < 8; ++k)
    bytes[bytes.size() - 8 + k] = static_cast<std::uint8_t>(hash >> (8 * k));
  return bytes;
}

void write_bytes(const std::filesystem::path& path, const Bytes& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

}  // namespace quicksand
