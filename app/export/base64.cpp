#include "app/export/base64.h"

#include <string_view>

namespace quicksand {

namespace {

constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kBlock = 1U << 16U;  // letters that are written at once

}  // namespace

void Base64::add(std::uint64_t word) {
  for (int byte = 0; byte < 8; ++byte, word >>= 8U) add_byte(static_cast<std::uint8_t>(word));
}

void Base64::finish() {
  const int missing = (3 - count_) % 3;
  for (int i = 0; i < missing; ++i) add_byte(0);
  for (int i = 0; i < missing; ++i) text_[text_.size() - 1 - static_cast<std::size_t>(i)] = '=';
  out_ << text_;
  text_.clear();
}

void Base64::add_byte(std::uint8_t byte) {
  bytes_ = bytes_ << 8U | byte;
  if (++count_ == 3) encode();
}

void Base64::encode() {
  // The text's end stays here until it is known whether it has to be filled up.
  if (text_.size() >= kBlock) {
    out_ << text_;
    text_.clear();
  }
  for (unsigned shift = 24; shift > 0;) text_ += kLetters[bytes_ >> (shift -= 6) & 63U];
  bytes_ = 0;
  count_ = 0;
}

}  // namespace quicksand
