// A checkpoint as an earlier version of the format would have left it: whole, but with another number.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace quicksand::test {

// `state` is what is in the file.
inline std::string of_an_older_version(std::string state) {
  const std::size_t version = state.find("gversion\x08");
  EXPECT_NE(version, std::string::npos) << "this version's number is another one";
  if (version == std::string::npos) return state;
  state[version + 8] = '\x03';
  // The checksum at the end, so that nothing but the version is wrong.
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : state.substr(0, state.size() - 9))
    hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3ULL;
  for (unsigned k = 0; k < 8; ++k) state[state.size() - 8 + k] = static_cast<char>(hash >> (8 * k));
  return state;
}

}  // namespace quicksand::test
