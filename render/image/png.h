// PNG files. Packing was the slowest part of a frame, so it goes straight to libdeflate, at its
// quickest level and without row filters, [PNG 2003].
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "render/image/image.h"

namespace quicksand {

constexpr std::array<std::uint8_t, 8> kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::uint8_t kUnfiltered = 0;  // before a row: its bytes are those of the pixels

// Bytes in the order of PNG, the highest first.
class PngBytes {
 public:
  PngBytes& number(std::uint32_t value) {
    return half(static_cast<std::uint16_t>(value >> 16U)).half(static_cast<std::uint16_t>(value));
  }
  PngBytes& half(std::uint16_t value) {
    all_.push_back(static_cast<std::uint8_t>(value >> 8U));
    all_.push_back(static_cast<std::uint8_t>(value));
    return *this;
  }
  PngBytes& bytes(std::span<const std::uint8_t> more) {
    all_.insert(all_.end(), more.begin(), more.end());
    return *this;
  }
  std::span<const std::uint8_t> all() const { return all_; }

 private:
  std::vector<std::uint8_t> all_;
};

// Length, name, data and checksum.
std::vector<std::uint8_t> png_chunk(std::string_view name, std::span<const std::uint8_t> data);
// Rows as zlib packs them; the level goes from 1, the quickest, to 12.
std::vector<std::uint8_t> packed(std::span<const std::uint8_t> rows, int level);

std::vector<std::uint8_t> encode_png(const Image& image);

// Whether the file is of whole pieces with their checksums, from the first to the last.
bool is_whole_png(const std::filesystem::path& path);

// No half a picture is ever seen. Throws InputError if the path cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace quicksand
