// Base64 as RFC 4648 defines it.
#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>

namespace quicksand {

// Writes bytes as they come, without keeping them.
class Base64 {
 public:
  explicit Base64(std::ostream& out) : out_(out) {}

  void add(std::uint8_t byte) {
    bytes_ = bytes_ << 8U | byte;
    if (++count_ == 3) write(0);
  }
  // Its bytes in little-endian order.
  void add_word(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte, word >>= 8U) add(static_cast<std::uint8_t>(word));
  }
  // The last bytes, and what fills them up to a multiple of three.
  void finish() {
    if (count_ == 0) return;
    const int missing = 3 - count_;
    bytes_ <<= 8U * static_cast<unsigned>(missing);
    write(missing);
  }

 private:
  void write(int missing) {
    constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<char, 4> letters{'=', '=', '=', '='};
    for (std::size_t k = 0; k < letters.size() - static_cast<std::size_t>(missing); ++k)
      letters[k] = kLetters[bytes_ >> (18U - 6U * k) & 63U];
    out_.write(letters.data(), letters.size());
    bytes_ = 0;
    count_ = 0;
  }

  std::ostream& out_;
  std::uint32_t bytes_ = 0;  // up to three, not written yet
  int count_ = 0;
};

inline std::string base64(std::string_view bytes) {
  std::ostringstream text;
  Base64 writer(text);
  for (const char byte : bytes) writer.add(static_cast<std::uint8_t>(byte));
  writer.finish();
  return text.str();
}

}  // namespace quicksand
