#include "core/checkpoint/cbor.h"

#include <stdexcept>

namespace quicksand {

namespace {

class Walk {
 public:
  explicit Walk(std::span<const std::uint8_t> rest) : rest_(rest) {}

  void over_item(int depth) {
    if (depth > kDeepest) throw std::runtime_error("it is nested too deep");
    ++items_;
    const std::uint8_t head = take(1)[0];
    const auto type = static_cast<Type>(head >> 5U);
    const std::uint64_t number = argument(head & 31U);
    if (type == tag) throw std::runtime_error("it has a tag");
    if (type == byte_string || type == text) take(number);
    if (type != array && type != map) return;
    // An item takes a byte at least, so that no number of them outlasts the bytes.
    for (std::uint64_t k = 0; k < number; ++k) {
      over_item(depth + 1);
      if (type == map) over_item(depth + 1);
    }
  }

  std::size_t items() const { return items_; }
  bool at_end() const { return rest_.empty(); }

 private:
  static constexpr int kDeepest = 16;
  // The types of RFC 8949, 3.1, that hold more than a number.
  enum Type : std::uint8_t { byte_string = 2, text, array, map, tag };

  std::span<const std::uint8_t> take(std::uint64_t count) {
    if (count > rest_.size()) throw std::runtime_error("it is cut short");
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }

  // A small number itself, or the big-endian one of 1, 2, 4 or 8 bytes that follows.
  std::uint64_t argument(unsigned info) {
    constexpr unsigned kShort = 24, kLong = 27;
    if (info < kShort) return info;
    if (info > kLong) throw std::runtime_error("it has an indefinite length");
    std::uint64_t number = 0;
    for (const std::uint8_t byte : take(std::uint64_t{1} << (info - kShort)))
      number = number << 8U | byte;
    return number;
  }

  std::span<const std::uint8_t> rest_;
  std::size_t items_ = 0;
};

}  // namespace

std::size_t count_cbor_items(std::span<const std::uint8_t> bytes) {
  Walk walk(bytes);
  walk.over_item(0);
  if (!walk.at_end()) throw std::runtime_error("more follows after its end");
  return walk.items();
}

}  // namespace quicksand
