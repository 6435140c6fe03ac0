// series.csv: one row a sample, one column a quantity. A row is on disk when add() returns.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

#include "app/run/quantities.h"

namespace quicksand {

class Series {
 public:
  // Starts a new file, or, to continue a run at a step, keeps the rows up to that step. Throws
  // InputError if the file cannot be written, or is not the series of such a run.
  explicit Series(std::filesystem::path path, std::optional<std::int64_t> up_to_step = {});

  void add(const Row& row);

  std::int64_t rows() const { return rows_; }
  // Step of the last row; -1 if there is none.
  std::int64_t last_step() const { return last_step_; }

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::int64_t rows_ = 0;
  std::int64_t last_step_ = -1;
};

// The first line: names of the quantities.
std::string series_header();

}  // namespace quicksand
