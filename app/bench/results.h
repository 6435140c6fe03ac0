// results.csv and results.json: every row, and what they were measured on.
#pragma once

#include <span>
#include <string>

#include "app/bench/bench.h"
#include "app/json/json_text.h"

namespace quicksand::bench {

// Names of the columns, then a line for each row.
std::string csv(std::span<const Row> rows);
// Machine, compiler and version, command, and the rows.
Json json(std::span<const Row> rows, const Options& options, const std::string& command);

// Writes both files as wholes. Throws InputError if they cannot be written.
void write_results(std::span<const Row> rows, const Options& options, const std::string& command);

}  // namespace quicksand::bench
