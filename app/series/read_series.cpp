#include "app/series/read_series.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <string>

namespace quicksand {

namespace {

struct PlottedColumn {
  std::string_view name;
  void (*set)(Row& row, double value);
};

constexpr auto kColumns = std::to_array<PlottedColumn>(
    {{"time", [](Row& row, double x) { row.sample.time = x; }},
     {"step", [](Row& row, double x) { row.sample.step = static_cast<std::int64_t>(x); }},
     {"active_bond_fraction", [](Row& row, double x) { row.sample.active_bond_fraction = x; }},
     {"coordination", [](Row& row, double x) { row.sample.coordination = x; }},
     {"depth",
      [](Row& row, double x) {
        row.sample.has_intruder = true;
        row.sample.depth = x;
      }},
     {"resistance", [](Row& row, double x) { row.sample.resistance = x; }},
     {"residual", [](Row& row, double x) { row.residual = x; }}});

Row row_of(const std::string& line, const std::vector<std::string>& names) {
  Row row;
  const std::vector<std::string_view> cells = cells_of(line);
  for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i) {
    if (names[i] == "phase") row.phase = cells[i];
    const auto column = std::ranges::find(kColumns, names[i], &PlottedColumn::name);
    double value = 0;
    if (column == kColumns.end() || cells[i].empty()) continue;
    const char* end = cells[i].data() + cells[i].size();
    if (std::from_chars(cells[i].data(), end, value).ec == std::errc()) column->set(row, value);
  }
  return row;
}

}  // namespace

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    cells.push_back(line.substr(start, end - start));
    start = end + 1;
  }
  return cells;
}

std::vector<Row> read_series(const std::filesystem::path& file, std::size_t most) {
  std::ifstream text(file, std::ios::binary);
  std::vector<std::string> names, lines;
  std::string line;
  if (!std::getline(text, line) || text.eof()) return {};
  for (const std::string_view name : cells_of(line)) names.emplace_back(name);
  while (std::getline(text, line) && !text.eof()) lines.push_back(line);
  const std::size_t every = std::max<std::size_t>(1, (lines.size() + most - 1) / most);
  std::vector<Row> rows;
  rows.reserve(lines.size() / every + 1);
  for (std::size_t k = 0; k < lines.size(); k += every) rows.push_back(row_of(lines[k], names));
  return rows;
}

}  // namespace quicksand
