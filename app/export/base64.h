// Writes 64-bit words as base64 text, without keeping them, as RFC 4648 defines it.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

namespace quicksand {

class Base64 {
 public:
  explicit Base64(std::ostream& out) : out_(out) {}

  void add(std::uint64_t word);  // its bytes in little-endian order
  void finish();                 // the last bytes, and what fills them up to a multiple of three

 private:
  void add_byte(std::uint8_t byte);
  void encode();

  std::ostream& out_;
  std::uint32_t bytes_ = 0;  // up to three, not written yet
  int count_ = 0;
  std::string text_;
};

}  // namespace quicksand
