// series.csv read back, as far as plots show it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "app/series/quantities.h"

namespace quicksand {

// Views into the line, which is without its end; an empty line has one cell, which is empty.
std::vector<std::string_view> cells_of(std::string_view line);

// Rows with time, step, phase and the plotted quantities, evenly thinned to at most `most`. A row without end is left
// out, as a run that still computes has one; so are columns that the file lacks. Empty if there is no such file.
std::vector<Row> read_series(const std::filesystem::path& file, std::size_t most);

}  // namespace quicksand
