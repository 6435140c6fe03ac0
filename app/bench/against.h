// Two results of the benchmark side by side: how many times as long the second takes for the same work.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/json/json_text.h"

namespace quicksand::bench {

constexpr double kRegression = 1.5;  // ratios above are marked

// The same problem, method and tolerance in both results; seconds are medians over repeats.
struct Ratio {
  std::string what;
  double before = 0, after = 0;                    // CPU time [s]
  double residual_before = 0, residual_after = 0;  // worst [1]
  double value() const { return after / before; }
  bool regression() const { return value() > kRegression; }
};

// Sorted from the largest ratio down. Measurements that only one result has are left out.
std::vector<Ratio> ratios(const Json& before, const Json& after);

// Reads results.json. Throws InputError if it is none.
Json read_results(const std::filesystem::path& file);

// The table with its verdict in the last line, and a warning where the machines differ.
std::string ratio_table(const Json& before, const Json& after);

}  // namespace quicksand::bench
