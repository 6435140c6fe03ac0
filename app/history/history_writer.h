// Writes history.qsh while a run computes: a record a sample, after which it can be read.
//
// Once the file is larger than its limit, every second record is dropped, and from then on every second sample is
// recorded. What is in the file follows from the rows alone: a run that was killed and resumed leaves the same bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/world/world.h"

namespace quicksand {

class HistoryWriter {
 public:
  // Begins a new file, or, to go on with a run, keeps the records of the first `kept_rows` rows. Where there are none,
  // or damaged ones, the history has a gap: no reason to compute again. `limit` [bytes]. Throws InputError if the file
  // cannot be read or written.
  HistoryWriter(std::filesystem::path path, std::int64_t kept_rows, std::int64_t limit);

  // The world at this row of series.csv; rows must ascend. Throws InputError.
  void add(const World& world, std::int64_t row, int phase, std::string_view phase_name);
  // Waits until the records are on the disk. Throws InputError.
  void secure() const;

 private:
  void begin();
  void keep(std::int64_t rows);
  void append_from_here();
  void thin_out();
  void require_written() const;

  std::filesystem::path path_;
  std::int64_t limit_;
  std::int64_t stride_ = 1;
  std::int64_t size_ = 0;  // of the file [bytes]
  std::ofstream file_;
};

}  // namespace quicksand
