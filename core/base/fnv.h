// The FNV-1a hash, of bytes or of words.
#pragma once

#include <cstdint>

namespace quicksand {

constexpr std::uint64_t kFnvStart = 0xCBF29CE484222325ULL;
constexpr std::uint64_t fnv1a(std::uint64_t hash, std::uint64_t next) {
  return (hash ^ next) * 0x100000001B3ULL;
}

}  // namespace quicksand
