#include "app/series/read_series.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <span>
#include <string>

namespace quicksand {

namespace {

// As text_of() has written it.
Value value_of(std::string_view cell) {
  if (cell.empty()) return {};
  const char* end = cell.data() + cell.size();
  std::int64_t whole = 0;
  if (std::from_chars(cell.data(), end, whole).ptr == end) return whole;
  double real = 0;
  if (std::from_chars(cell.data(), end, real).ptr == end) return real;
  return std::string(cell);
}

Values row_of(const std::string& line, std::span<const std::optional<std::size_t>> places) {
  Values row(quantities().size());
  const std::vector<std::string_view> cells = cells_of(line);
  for (std::size_t i = 0; i < std::min(cells.size(), places.size()); ++i)
    if (places[i]) row[*places[i]] = value_of(cells[i]);
  return row;
}

// Of each column among the quantities; none of one that is not known.
std::vector<std::optional<std::size_t>> places_of(const std::string& header) {
  std::vector<std::optional<std::size_t>> places;
  for (const std::string_view name : cells_of(header)) {
    const auto found = std::ranges::find(quantities(), name, &Quantity::name);
    places.emplace_back();
    if (found != quantities().end()) places.back() = found - quantities().begin();
  }
  return places;
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

std::vector<Values> read_series(const std::filesystem::path& file, std::size_t most) {
  std::ifstream text(file, std::ios::binary);
  std::vector<std::string> lines;
  std::string line;
  if (!std::getline(text, line) || text.eof()) return {};
  const std::vector<std::optional<std::size_t>> places = places_of(line);
  while (std::getline(text, line) && !text.eof()) lines.push_back(line);
  const std::size_t every = std::max<std::size_t>(1, (lines.size() + most - 1) / most);
  std::vector<Values> rows;
  rows.reserve(lines.size() / every + 1);
  for (std::size_t k = 0; k < lines.size(); k += every) rows.push_back(row_of(lines[k], places));
  return rows;
}

}  // namespace quicksand
