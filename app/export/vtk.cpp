// An array is the base64 text of its length in bytes (UInt64) and its numbers. The values of points
// belong to them as point data, those of lines as cell data.
#include <bit>

#include "app/export/formats.h"
#include "app/json/base64.h"
#include "app/json/json_reader.h"

namespace quicksand {

namespace {

// Writes <DataArray>; value(row, component) gives its words.
template <class WordOf>
void write_array(std::ostream& out, std::string_view name, DataColumn::Kind kind, int rows,
                 int size, const WordOf& value) {
  out << "<DataArray type=\"" << (kind == DataColumn::Kind::integer ? "Int64" : "Float64")
      << "\" Name=\"" << name << "\" NumberOfComponents=\"" << size << "\" format=\"binary\">";
  Base64 text(out);
  text.add_word(std::uint64_t{8} * static_cast<std::uint64_t>(rows) *
                static_cast<std::uint64_t>(size));
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < size; ++k) text.add_word(value(row, k));
  text.finish();
  out << "</DataArray>\n";
}

void write_columns(std::ostream& out, const ExportedWorld& world, const DataTable& table) {
  for (const DataColumn& column : table.columns) {
    if (table.corners == 1 && column.name == kPosition) continue;  // they are the points
    const int size = column.size == 2 ? 3 : 1;
    write_array(out, column.name, column.kind, table.rows(world), size, [&](int row, int k) {
      return k < column.size ? word_of(column, column.get(world, row, k)) : 0;
    });
  }
}

void write_points(std::ostream& out, const ExportedWorld& world, const DataTable& table) {
  const int rows = table.rows(world) * table.corners;
  write_array(out, "Points", DataColumn::Kind::real, rows, 3, [&](int row, int k) {
    if (k == 2) return std::uint64_t{0};
    return std::bit_cast<std::uint64_t>(
        table.corner(world, row / table.corners, row % table.corners)[k]);
  });
}

// Each row is a cell of the points that are its own.
void write_cells(std::ostream& out, int rows, int corners) {
  write_array(out, "connectivity", DataColumn::Kind::integer, rows * corners, 1,
              [](int row, int) { return static_cast<std::uint64_t>(row); });
  write_array(out, "offsets", DataColumn::Kind::integer, rows, 1, [&](int row, int) {
    return static_cast<std::uint64_t>(row + 1) * static_cast<std::uint64_t>(corners);
  });
}

}  // namespace

void write_vtk(std::ostream& out, const ExportedWorld& world, const DataTable& table) {
  const int rows = table.rows(world);
  const bool points = table.corners == 1;
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n"
         "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">"
      << number_text(world.world.time) << "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\""
      << rows * table.corners << "\" NumberOfVerts=\"" << (points ? rows : 0)
      << "\" NumberOfLines=\"" << (points ? 0 : rows)
      << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  out << (points ? "<PointData>\n" : "<CellData>\n");
  write_columns(out, world, table);
  out << (points ? "</PointData>\n" : "</CellData>\n") << "<Points>\n";
  write_points(out, world, table);
  out << "</Points>\n" << (points ? "<Verts>\n" : "<Lines>\n");
  write_cells(out, rows, table.corners);
  out << (points ? "</Verts>\n" : "</Lines>\n") << "</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string vtk_collection(std::span<const TimedFile> files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const TimedFile& known : files) {
    text += "<DataSet timestep=\"" + number_text(known.time) + "\" part=\"0\" file=\"" +
            known.file + "\"/>\n";
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace quicksand
