// How numbers and columns of numbers become bytes and numbers again: one description for both directions, as in a
// checkpoint, without the keys.
//
// A column is written by bytes of equal weight: the first byte of all its items, then the second one of all. Signs,
// exponents and high bytes are then beside their likes, and packing finds what they have in common.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace quicksand {

static_assert(std::endian::native == std::endian::little, "numbers are stored little-endian");

using Bytes = std::vector<std::uint8_t>;

class ColumnWriter {
 public:
  static constexpr bool kReads = false;

  // A plain value without padding.
  template <class T>
  void value(const T& x) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&x);
    bytes_.insert(bytes_.end(), bytes, bytes + sizeof x);
  }
  template <class T>
  void column(const std::vector<T>& items) {
    static_assert(std::is_arithmetic_v<T>);
    value(static_cast<std::uint32_t>(items.size()));
    const std::size_t start = bytes_.size(), n = items.size();
    bytes_.resize(start + n * sizeof(T));
    const auto* from = reinterpret_cast<const std::uint8_t*>(items.data());
    for (std::size_t plane = 0; plane < sizeof(T); ++plane)
      for (std::size_t k = 0; k < n; ++k)
        bytes_[start + plane * n + k] = from[k * sizeof(T) + plane];
  }
  const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

// Throws std::runtime_error where the bytes end too soon.
class ColumnReader {
 public:
  static constexpr bool kReads = true;

  explicit ColumnReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <class T>
  void value(T& x) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    const auto bytes = take(sizeof x);
    if constexpr (std::is_same_v<T, bool>)
      x = bytes[0] != 0;
    else
      std::memcpy(&x, bytes.data(), sizeof x);
  }
  template <class T>
  void column(std::vector<T>& items) {
    std::uint32_t size = 0;
    value(size);
    const std::size_t n = size;
    const auto bytes = take(n * sizeof(T));
    items.resize(n);
    auto* to = reinterpret_cast<std::uint8_t*>(items.data());
    for (std::size_t plane = 0; plane < sizeof(T); ++plane)
      for (std::size_t k = 0; k < n; ++k) to[k * sizeof(T) + plane] = bytes[plane * n + k];
  }
  bool at_end() const { return rest_.empty(); }

 private:
  std::span<const std::uint8_t> take(std::size_t size) {
    if (size > rest_.size()) throw std::runtime_error("it is cut short");
    const auto taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }

  std::span<const std::uint8_t> rest_;
};

// Whether it is there, then what it is: `describe(value)` visits it.
template <class Archive, class Optional, class Describe>
void optional_value(Archive& archive, Optional& x, Describe describe) {
  bool there = x.has_value();
  archive.value(there);
  if constexpr (Archive::kReads) {
    if (there) x.emplace();
  }
  if (there) describe(*x);
}

}  // namespace quicksand
