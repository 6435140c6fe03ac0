#include "render/image/png.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <string_view>
#include <system_error>

#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {
namespace {

constexpr int kQuickest = 1;  // level of compression

struct FreeCompressor {
  void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};

// Each row after a zero: no filter.
std::vector<std::uint8_t> unfiltered_rows(const Image& image) {
  const std::size_t row = static_cast<std::size_t>(image.width) * 3;
  const auto height = static_cast<std::size_t>(image.height);
  std::vector<std::uint8_t> rows(height * (row + 1));
  for (std::size_t y = 0; y < height; ++y) {
    std::memcpy(&rows[y * (row + 1) + 1], &image.rgb[y * row], row);
  }
  return rows;
}

}  // namespace

std::vector<std::uint8_t> png_chunk(std::string_view name, std::span<const std::uint8_t> data) {
  const std::span name_bytes(reinterpret_cast<const std::uint8_t*>(name.data()), name.size());
  std::uint32_t checksum = libdeflate_crc32(0, name_bytes.data(), name_bytes.size());
  if (!data.empty()) checksum = libdeflate_crc32(checksum, data.data(), data.size());
  PngBytes chunk;
  chunk.number(static_cast<std::uint32_t>(data.size())).bytes(name_bytes);
  chunk.bytes(data).number(checksum);
  return {chunk.all().begin(), chunk.all().end()};
}

std::vector<std::uint8_t> packed(std::span<const std::uint8_t> rows, int level) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
      libdeflate_alloc_compressor(level));
  if (!compressor) throw std::bad_alloc();
  std::vector<std::uint8_t> out(libdeflate_zlib_compress_bound(compressor.get(), rows.size()));
  out.resize(
      libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(), out.data(), out.size()));
  return out;
}

std::vector<std::uint8_t> encode_png(const Image& image) {
  constexpr std::array<std::uint8_t, 5> kRgb8{8, 2, 0, 0, 0};  // bits, RGB, standard methods
  PngBytes head;
  head.number(static_cast<std::uint32_t>(image.width));
  head.number(static_cast<std::uint32_t>(image.height)).bytes(kRgb8);
  PngBytes out;
  out.bytes(kPngSignature).bytes(png_chunk("IHDR", head.all()));
  out.bytes(png_chunk("IDAT", packed(unfiltered_rows(image), kQuickest)));
  out.bytes(png_chunk("IEND", {}));
  return {out.all().begin(), out.all().end()};
}

void write_png(const std::filesystem::path& path, const Image& image) {
  const std::vector<std::uint8_t> bytes = encode_png(image);
  WholeFile file(path);
  file.stream().write(reinterpret_cast<const char*>(bytes.data()),
                      static_cast<std::streamsize>(bytes.size()));
  file.finish_soon();
}

bool is_whole_png(const std::filesystem::path& path) {
  constexpr std::size_t kAround = 12;  // length, name and checksum of a piece
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::ifstream file(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  std::span<const std::uint8_t> left = bytes;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (const std::uint8_t byte : left.subspan(at, 4)) value = value << 8U | byte;
    return value;
  };
  if (left.size() < kPngSignature.size() ||
      !std::ranges::equal(left.first(kPngSignature.size()), kPngSignature))
    return false;
  left = left.subspan(kPngSignature.size());
  bool ended = false;
  while (!ended && left.size() >= kAround && number(0) <= left.size() - kAround) {
    const std::size_t size = number(0);
    if (libdeflate_crc32(0, &left[4], size + 4) != number(size + 8)) return false;
    ended = size == 0 && std::ranges::equal(left.subspan(4, 4), std::string_view("IEND"));
    left = left.subspan(size + kAround);
  }
  return ended && left.empty();
}

}  // namespace quicksand
