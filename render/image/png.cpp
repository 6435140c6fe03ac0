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
constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

struct FreeCompressor {
  void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};

std::array<std::uint8_t, 4> big_endian(std::uint32_t value) {
  return {static_cast<std::uint8_t>(value >> 24U), static_cast<std::uint8_t>(value >> 16U),
          static_cast<std::uint8_t>(value >> 8U), static_cast<std::uint8_t>(value)};
}

template <typename Bytes>
void append(std::vector<std::uint8_t>& out, const Bytes& bytes) {
  for (const auto byte : bytes) out.push_back(static_cast<std::uint8_t>(byte));
}

// Ends a chunk: its checksum covers name and data, which begin at `name_at`.
void append_checksum(std::vector<std::uint8_t>& out, std::size_t name_at) {
  append(out, big_endian(libdeflate_crc32(0, &out[name_at], out.size() - name_at)));
}

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

std::vector<std::uint8_t> encode_png(const Image& image) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
      libdeflate_alloc_compressor(kQuickest));
  if (!compressor) throw std::bad_alloc();
  const std::vector<std::uint8_t> rows = unfiltered_rows(image);
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), rows.size());

  std::vector<std::uint8_t> out;
  out.reserve(bound + 100);
  append(out, kSignature);

  append(out, big_endian(13));
  std::size_t name_at = out.size();
  append(out, std::string_view("IHDR"));
  append(out, big_endian(static_cast<std::uint32_t>(image.width)));
  append(out, big_endian(static_cast<std::uint32_t>(image.height)));
  constexpr std::array<std::uint8_t, 5> kRgb8{8, 2, 0, 0, 0};  // bits, RGB, standard methods
  append(out, kRgb8);
  append_checksum(out, name_at);

  const std::size_t size_at = out.size();
  append(out, big_endian(0));
  name_at = out.size();
  append(out, std::string_view("IDAT"));
  const std::size_t data_at = out.size();
  out.resize(data_at + bound);
  const std::size_t packed =
      libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(), &out[data_at], bound);
  out.resize(data_at + packed);
  const auto size = big_endian(static_cast<std::uint32_t>(packed));
  std::copy(size.begin(), size.end(), out.begin() + static_cast<std::ptrdiff_t>(size_at));
  append_checksum(out, name_at);

  append(out, big_endian(0));
  name_at = out.size();
  append(out, std::string_view("IEND"));
  append_checksum(out, name_at);
  return out;
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
  std::array<char, kSignature.size()> begin{};
  std::array<char, kEnd.size()> end{};
  file.read(begin.data(), begin.size());
  file.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  file.read(end.data(), end.size());
  const auto same = [](char a, auto b) { return a == static_cast<char>(b); };
  return file && std::equal(begin.begin(), begin.end(), kSignature.begin(), same) && end == kEnd;
}

}  // namespace quicksand
