// Disks as a frame of an extended XYZ file: their number, a line that describes the frame and the
// columns, a line a disk. Readers look for some columns under names of their own, and some take only
// symbols of chemical elements for a species: grains are Si, intruders are I.
#include <algorithm>

#include "app/export/formats.h"
#include "app/json/json_reader.h"

namespace quicksand {

namespace {

std::string_view name_in_xyz(std::string_view name) {
  if (name == kPosition) return "pos";
  if (name == "velocity") return "velo";
  if (name == "disk") return "id";
  return name;
}

std::string properties(const DataTable& table) {
  std::string text = "species:S:1";
  for (const DataColumn& column : table.columns) {
    text += ":" + std::string(name_in_xyz(column.name)) +
            (column.kind == DataColumn::Kind::integer ? ":I:" : ":R:") +
            (column.size == 2 ? "3" : "1");
  }
  return text;
}

// The cell of the frame: what box and disks cover, 1 d deep.
std::string description(const ExportedWorld& world, const DataTable& table) {
  const Vec2 size = world.covered.high - world.covered.low;
  std::string text = "Lattice=\"" + number_text(size.x()) + " 0 0 0 " + number_text(size.y()) +
                     " 0 0 0 1\" Origin=\"" + number_text(world.covered.low.x()) + " " +
                     number_text(world.covered.low.y()) +
                     " -0.5\" Properties=" + properties(table) + " pbc=\"" +
                     (world.world.box.sides == Sides::periodic ? "T" : "F") + " F F\"";
  return text + " Time=" + number_text(world.world.time) +
         " Step=" + std::to_string(world.world.step);
}

}  // namespace

void write_xyz(std::ostream& out, const ExportedWorld& world, const DataTable& table) {
  const int rows = table.rows(world);
  out << rows << '\n' << description(world, table) << '\n';
  std::string line;
  for (int row = 0; row < rows; ++row) {
    line = world.world.disks.role[static_cast<std::size_t>(row)] == Role::intruder ? "I" : "Si";
    for (const DataColumn& column : table.columns) {
      for (int k = 0; k < column.size; ++k) {
        line += ' ';
        append_text(line, column, column.get(world, row, k));
      }
      if (column.size == 2) line += " 0";
    }
    out << line << '\n';
  }
}

}  // namespace quicksand
