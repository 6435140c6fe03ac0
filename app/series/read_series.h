// series.csv read back.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "app/series/quantities.h"

namespace quicksand {

// Views into the line, which is without its end; an empty line has one cell, which is empty.
std::vector<std::string_view> cells_of(std::string_view line);

// The rows, evenly thinned to at most `most`. A row without end is left out, as a run that still computes has one; of a
// column that the file lacks there is no value. Empty if there is no such file.
std::vector<Values> read_series(const std::filesystem::path& file, std::size_t most);

}  // namespace quicksand
