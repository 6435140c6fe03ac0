// series.csv: one row a sample, one column a quantity. A row is on disk when add() returns.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "app/series/quantities.h"
#include "core/base/whole_file.h"

namespace quicksand {

class Series {
 public:
  // Starts a new file, or, to go on with a run, keeps so many rows of what is there. Throws InputError if
  // the file cannot be written, or has not so many rows of these quantities.
  explicit Series(std::filesystem::path path, std::int64_t kept_rows = 0);

  void add(const Values& row);
  // Waits until the rows are on the disk. Throws InputError.
  void secure() const { bring_to_disk(path_); }

  std::int64_t rows() const { return rows_; }
  // Of the header and all rows.
  std::uint64_t checksum() const { return checksum_; }

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::int64_t rows_ = 0;
  std::uint64_t checksum_ = 0;
};

// Whether a file begins with so many whole rows of these quantities, which have this checksum; 0: whatever they have.
bool has_rows(const std::filesystem::path& path, std::int64_t rows, std::uint64_t checksum);

// The first line: names of the quantities.
std::string series_header();

}  // namespace quicksand
