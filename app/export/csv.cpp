#include "app/export/formats.h"

namespace quicksand {

void write_csv(std::ostream& out, const ExportedWorld& world, const DataTable& table) {
  std::string line;
  const auto end_line = [&] {
    line.back() = '\n';  // instead of the last comma
    out << line;
    line.clear();
  };
  for (const DataColumn& column : table.columns)
    for (int k = 0; k < column.size; ++k) line += component_name(column, k) + ",";
  end_line();
  const int rows = table.rows(world);
  for (int row = 0; row < rows; ++row) {
    for (const DataColumn& column : table.columns) {
      for (int k = 0; k < column.size; ++k) {
        append_text(line, column, column.get(world, row, k));
        line += ',';
      }
    }
    end_line();
  }
}

}  // namespace quicksand
