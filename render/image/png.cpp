#include "render/image/png.h"

#include <libdeflate.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
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

void write_png(const std::filesystem::path& place, const Image& image) {
  const std::filesystem::path path = file_named(place);
  const std::vector<std::uint8_t> bytes = encode_png(image);
  std::filesystem::path part = path;
  part += ".part";
  std::ofstream file(part, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  file.close();
  std::error_code error, ignored;
  if (!file)
    error.assign(errno != 0 ? errno : EIO, std::generic_category());
  else
    std::filesystem::rename(part, path, error);
  if (!error) return;
  std::filesystem::remove(part, ignored);
  refuse_to_write(path, error.value());
}

bool is_whole_png(const std::filesystem::path& path) {
  // The last chunk is always the same: no bytes, its name, its checksum.
  constexpr std::array<char, 12> kEnd{0,   0,   0,      0,      'I',    'E',
                                      'N', 'D', '\xAE', '\x42', '\x60', '\x82'};
  std::ifstream file(path, std::ios::binary);
  std::array<char, kPngSignature.size()> begin{};
  std::array<char, kEnd.size()> end{};
  file.read(begin.data(), begin.size());
  file.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  file.read(end.data(), end.size());
  const auto same = [](char a, auto b) { return a == static_cast<char>(b); };
  return file && std::equal(begin.begin(), begin.end(), kPngSignature.begin(), same) && end == kEnd;
}

}  // namespace quicksand
