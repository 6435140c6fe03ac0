// What the benchmark says: a table on standard output, and results.csv and results.json in its folder.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/bench_case.h"

namespace quicksand::bench {

struct Result {
  std::string name;  // of the case
  Outcome outcome;
  std::string error;  // why the case has no outcome; empty if it has
};

std::string table_header();
// A line for each figure of the case. Goals are those of full size: quick runs are not held to them.
std::string table_rows(const Result& result, const Options& options);
// Whether the median reaches the goal and nothing besides speed is missing.
bool goal_met(const Figure& figure);
// What a reader must know to judge the figures of the case; empty if nothing.
std::string remarks(const Result& result);

// Names of the columns of results.csv, then a line for each run.
std::string csv(const std::vector<Result>& results);
// Machine, compiler and version, figures, notes and runs.
std::string json(const std::vector<Result>& results, const Options& options);

// Writes both files beside their names, then renames. Throws InputError if they cannot be written.
void write_results(const std::vector<Result>& results, const Options& options);

}  // namespace quicksand::bench
