// What history.qsh is made of: a head, then a record a sample, each with a head of its own and a snapshot that zstd
// packs. Heads have a fixed size and say how long the record is, so that a scan from head to head finds all of them in
// a file of any length, also while it grows.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/history/columns.h"
#include "core/world/world.h"

namespace quicksand {

// When a sample was taken, and what a timeline shows of it.
struct Moment {
  std::int64_t row = 0;  // of series.csv, from 0
  double time = 0;       // [sqrt(d/g)]
  std::int64_t step = 0;
  int phase = 0;  // index
  std::string phase_name;
  std::int64_t grains = 0;
  std::int64_t bonds_active = 0;
  std::int64_t bonds_formed = 0, bonds_broken = 0;  // since the beginning

  bool operator==(const Moment&) const = default;
};

struct RecordHead {
  Moment moment;
  std::uint64_t packed = 0;    // bytes that follow
  std::uint64_t unpacked = 0;  // of the snapshot [bytes]
  std::uint64_t checksum = 0;  // of the packed bytes

  bool operator==(const RecordHead&) const = default;
};

constexpr std::size_t kFileHeadSize = 32;
constexpr std::size_t kRecordHeadSize = 120;

// The file's head. `stride`: every so many rows have a record.
std::array<std::uint8_t, kFileHeadSize> file_head(std::int64_t stride);
// Its stride. Throws std::runtime_error with a phrase if it is no such head.
std::int64_t stride_from(std::span<const std::uint8_t, kFileHeadSize> bytes);

// Head and packed snapshot.
Bytes record_of(const World& world, std::int64_t row, int phase, std::string_view phase_name);
// Nothing if it is no such head, or damaged.
std::optional<RecordHead> head_from(std::span<const std::uint8_t, kRecordHeadSize> bytes);
// Throws std::runtime_error with a phrase if the bytes are damaged.
World world_from_record(const RecordHead& head, std::span<const std::uint8_t> packed);

}  // namespace quicksand
