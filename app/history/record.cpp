#include "app/history/record.h"

#include <zstd.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "app/history/snapshot.h"
#include "core/base/fnv.h"
#include "core/base/memory.h"

namespace quicksand {

namespace {

constexpr std::array<char, 8> kFormat{'q', 's', 'h', 'i', 's', 't', 'o', 'r'};
constexpr std::array<char, 8> kRecord{'q', 's', 'r', 'e', 'c', 'o', 'r', 'd'};
constexpr std::uint64_t kVersion = 3;
constexpr std::size_t kNameSize = 16;
constexpr std::int64_t kLongestStride = std::int64_t{1} << 40U;
constexpr int kLevel = 1;  // more takes longer and saves a hundredth: most bytes are noise
constexpr std::uint64_t kLargestSnapshot = std::uint64_t{4} << 30U;  // [bytes]
// Reading takes the bytes, their columns and the world.
constexpr double kBytesPerByte = 6;

// FNV-1a, eight bytes at a time.
std::uint64_t checksum(std::span<const std::uint8_t> bytes) {
  std::uint64_t hash = kFnvStart;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof hash) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
    hash = fnv1a(hash, word);
  }
  return hash;
}

// Heads end with the checksum of what is before it.
template <std::size_t size>
std::array<std::uint8_t, size> sealed(ColumnWriter writer) {
  writer.value(checksum(writer.bytes()));
  assert(writer.bytes().size() == size);
  std::array<std::uint8_t, size> head{};
  std::ranges::copy(writer.bytes(), head.begin());
  return head;
}

template <class Archive, class Head>
void describe_head(Archive& archive, Head& head, std::array<char, kNameSize>& name) {
  auto& moment = head.moment;
  archive.value(moment.row), archive.value(moment.time), archive.value(moment.step);
  archive.value(moment.grains), archive.value(moment.bonds_active);
  archive.value(moment.bonds_formed), archive.value(moment.bonds_broken);
  archive.value(head.packed), archive.value(head.unpacked), archive.value(head.checksum);
  auto phase = std::int64_t{moment.phase};
  archive.value(phase);
  if constexpr (Archive::kReads) moment.phase = static_cast<int>(phase);
  for (char& letter : name) archive.value(letter);
}

template <class Archive, std::size_t size>
void describe_letters(Archive& archive, std::array<char, size>& letters) {
  for (char& letter : letters) archive.value(letter);
}

Bytes packed(const Bytes& bytes) {
  Bytes out(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(ZSTD_getErrorName(size));
  out.resize(size);
  return out;
}

}  // namespace

std::array<std::uint8_t, kFileHeadSize> file_head(std::int64_t stride) {
  ColumnWriter writer;
  auto format = kFormat;
  describe_letters(writer, format);
  writer.value(kVersion);
  writer.value(stride);
  return sealed<kFileHeadSize>(std::move(writer));
}

std::int64_t stride_from(std::span<const std::uint8_t, kFileHeadSize> bytes) {
  ColumnReader reader(bytes);
  std::array<char, 8> format{};
  std::uint64_t version = 0, hash = 0;
  std::int64_t stride = 0;
  describe_letters(reader, format);
  reader.value(version), reader.value(stride), reader.value(hash);
  if (format != kFormat) throw std::runtime_error("is not the history of a run");
  if (hash != checksum(bytes.first(kFileHeadSize - sizeof hash)) || stride < 1 ||
      stride > kLongestStride)
    throw std::runtime_error("is damaged at its first bytes");
  if (version != kVersion)
    throw std::runtime_error("has format version " + std::to_string(version) +
                             ", this program reads version " + std::to_string(kVersion));
  return stride;
}

Bytes record_of(const World& world, std::int64_t row, int phase, std::string_view phase_name) {
  const Bytes snapshot = snapshot_of(world);
  const Bytes body = packed(snapshot);
  const std::int64_t active = std::ranges::count(world.bonds.list, BondState::active, &Bond::state);
  const RecordHead head{.moment = {.row = row,
                                   .time = world.time,
                                   .step = world.step,
                                   .phase = phase,
                                   .grains = std::ranges::count(world.disks.role, DiskRole::grain),
                                   .bonds_active = active,
                                   .bonds_formed = world.bonds.formed,
                                   .bonds_broken = world.bonds.broken},
                        .packed = body.size(),
                        .unpacked = snapshot.size(),
                        .checksum = checksum(body)};
  std::array<char, kNameSize> name{};
  std::ranges::copy(phase_name.substr(0, kNameSize), name.begin());
  ColumnWriter writer;
  auto mark = kRecord;
  describe_letters(writer, mark);
  describe_head(writer, head, name);
  const auto sealed_head = sealed<kRecordHeadSize>(std::move(writer));
  Bytes record(sealed_head.begin(), sealed_head.end());
  record.insert(record.end(), body.begin(), body.end());
  return record;
}

std::optional<RecordHead> head_from(std::span<const std::uint8_t, kRecordHeadSize> bytes) {
  ColumnReader reader(bytes);
  std::array<char, 8> mark{};
  std::array<char, kNameSize> name{};
  std::uint64_t hash = 0;
  RecordHead head;
  describe_letters(reader, mark);
  describe_head(reader, head, name);
  reader.value(hash);
  if (mark != kRecord || hash != checksum(bytes.first(kRecordHeadSize - sizeof hash)) ||
      !std::isfinite(head.moment.time))
    return std::nullopt;
  head.moment.phase_name.assign(name.begin(), std::ranges::find(name, '\0'));
  return head;
}

World world_from_record(const RecordHead& head, std::span<const std::uint8_t> packed) {
  if (checksum(packed) != head.checksum) throw std::runtime_error("its checksum is wrong");
  if (head.unpacked > kLargestSnapshot) throw std::runtime_error("it is larger than 4 GiB");
  const auto size = static_cast<double>(head.unpacked);
  if (const std::string problem = memory_problem(kBytesPerByte * size); !problem.empty())
    throw NotEnoughMemory("reading it " + problem);
  Bytes bytes(head.unpacked);
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(got) != 0) throw std::runtime_error(ZSTD_getErrorName(got));
  if (got != bytes.size()) throw std::runtime_error("it is cut short");
  World world = world_from_snapshot(bytes);
  if (world.time != head.moment.time || world.step != head.moment.step)
    throw std::runtime_error("it belongs to another moment");
  return world;
}

}  // namespace quicksand
