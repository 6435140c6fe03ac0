// A file is the magic text, the version 1.0, the length of the header as 16 bits, the header (a Python
// dictionary, filled up with spaces so that the data begin at a multiple of 64 bytes), and the rows.
#include <bit>
#include <cstring>

#include "app/export/formats.h"

namespace quicksand {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are stored little-endian");

std::string dictionary(const DataTable& table, int rows) {
  std::string text = "{'descr': [";
  for (const DataColumn& column : table.columns) {
    text += "('" + std::string(column.name) + "', '" +
            (column.kind == DataColumn::Kind::integer ? "<i8" : "<f8") + "'" +
            (column.size == 1 ? "), " : ", (" + std::to_string(column.size) + ",)), ");
  }
  return text + "], 'fortran_order': False, 'shape': (" + std::to_string(rows) + ",), }";
}

std::string header(const DataTable& table, int rows) {
  constexpr std::size_t kAlignment = 64;
  std::string text("\x93NUMPY\x01\x00\x00\x00", 10);
  text += dictionary(table, rows);
  text.resize((text.size() / kAlignment + 1) * kAlignment, ' ');
  text.back() = '\n';
  const auto length = static_cast<std::uint16_t>(text.size() - 10);
  std::memcpy(text.data() + 8, &length, sizeof length);
  return text;
}

}  // namespace

void write_npy(std::ostream& out, const ExportedWorld& world, const DataTable& table) {
  const int rows = table.rows(world);
  out << header(table, rows);
  std::vector<std::uint64_t> words;
  for (int row = 0; row < rows; ++row) {
    words.clear();
    for (const DataColumn& column : table.columns)
      for (int k = 0; k < column.size; ++k)
        words.push_back(word_of(column, column.get(world, row, k)));
    out.write(reinterpret_cast<const char*>(words.data()),
              static_cast<std::streamsize>(words.size() * sizeof words[0]));
  }
}

}  // namespace quicksand
