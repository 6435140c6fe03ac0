// A message of numbers: the size of its head, the head in JSON, which names the arrays, and the arrays one after the
// other, each from a multiple of four bytes on. All in the order of bytes of this machine, which is that of browsers.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "app/json/json_text.h"

namespace quicksand {

class BinaryMessage {
 public:
  static_assert(std::endian::native == std::endian::little);

  void add(const char* name, std::span<const float> values) { add(name, "f32", values); }
  void add(const char* name, std::span<const std::int32_t> values) { add(name, "i32", values); }
  void add(const char* name, std::span<const std::uint16_t> values) { add(name, "u16", values); }
  void add(const char* name, std::span<const std::uint8_t> values) { add(name, "u8", values); }

  // The whole message, with this head.
  std::string finish(Json head) const {
    head["arrays"] = arrays_;
    std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize(rounded(text.size()), ' ');
    const auto size = static_cast<std::uint32_t>(text.size());
    std::string message(sizeof size, '\0');
    std::memcpy(message.data(), &size, sizeof size);
    message.reserve(message.size() + text.size() + bytes_.size());
    return message.append(text).append(bytes_);
  }

 private:
  static std::size_t rounded(std::size_t size) { return (size + 3) / 4 * 4; }

  template <class Number>
  void add(const char* name, const char* type, std::span<const Number> values) {
    arrays_.push_back({name, type, values.size()});
    const std::size_t start = bytes_.size();
    bytes_.resize(start + rounded(values.size_bytes()));
    if (!values.empty()) std::memcpy(bytes_.data() + start, values.data(), values.size_bytes());
  }

  Json arrays_ = Json::array();
  std::string bytes_;
};

}  // namespace quicksand
