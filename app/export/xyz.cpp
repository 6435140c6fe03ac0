// Disks as a frame of an extended XYZ file: their number, a line that describes the frame and the
// columns, a line a disk. Readers look for some columns under names of their own, and some take only
// symbols of chemical elements for a species: grains are Si, intruders are I. Readers know no shapes, so the outline
// of an intruder of several parts follows as a string of points, O, with all else that the intruder has but its number,
// which is in the last column: readers want an id of its own for each line.
#include <algorithm>
#include <vector>

#include "app/export/formats.h"
#include "app/json/json_reader.h"

namespace quicksand {

namespace {

constexpr std::string_view kNumber = "disk";  // of a body

std::string_view name_in_xyz(std::string_view name) {
  if (name == kPosition) return "pos";
  if (name == "velocity") return "velo";
  if (name == kNumber) return "id";
  return name;
}

std::string properties(const DataTable& table) {
  std::string text = "species:S:1";
  for (const DataColumn& column : table.columns) {
    text += ":" + std::string(name_in_xyz(column.name)) +
            (column.kind == DataColumn::Kind::integer ? ":I:" : ":R:") +
            (column.size == 2 ? "3" : "1");
  }
  return text + ":body:I:1";
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

// The id of the first point of the outlines, above the numbers of all disks: those that a later state adds have none of
// them, and a point has one id in all states.
constexpr int kFirstPoint = 1'000'000'000;

// A point of the outline of a body.
struct OutlinePoint {
  int id = 0;
  int body = 0;
  Vec2 place{0, 0};
  double radius = 0;  // half of the distance to the next
};

std::vector<OutlinePoint> points_of(const std::vector<OutlinePiece>& outlines) {
  constexpr double kApart = 0.1, kMost = 20000;  // [d], points
  double length = 0;
  for (const OutlinePiece& piece : outlines) length += (piece.to - piece.from).norm();
  const double apart = std::max(kApart, length / kMost);
  std::vector<OutlinePoint> points;
  double begins = 0;  // of the piece, along all outlines
  for (const OutlinePiece& piece : outlines) {
    const double piece_length = (piece.to - piece.from).norm();
    const auto next = [&] { return static_cast<double>(points.size()) * apart - begins; };
    while (next() < piece_length)
      points.push_back({kFirstPoint + static_cast<int>(points.size()), piece.body,
                        piece.from + next() / piece_length * (piece.to - piece.from), apart / 2});
    begins += piece_length;
  }
  return points;
}

// The line of a disk, or of a point of its outline.
std::string line_of(const ExportedWorld& world, const DataTable& table, int row,
                    const OutlinePoint* point) {
  const bool intruder = world.world.disks.role[static_cast<std::size_t>(row)] == DiskRole::intruder;
  std::string line = point ? "O" : intruder ? "I" : "Si";
  for (const DataColumn& column : table.columns) {
    for (int k = 0; k < column.size; ++k) {
      double value = column.get(world, row, k);
      if (point && column.name == kPosition) value = point->place[k];
      if (point && column.name == "radius") value = point->radius;
      if (point && column.name == kNumber) value = point->id;
      line += ' ';
      append_text(line, column, value);
    }
    if (column.size == 2) line += " 0";
  }
  return line + ' ' + std::to_string(row) + '\n';
}

}  // namespace

void write_xyz(std::ostream& out, const ExportedWorld& world, const DataTable& table) {
  const int rows = table.rows(world);
  const std::vector<OutlinePoint> points = points_of(world.outlines);
  out << static_cast<std::size_t>(rows) + points.size() << '\n'
      << description(world, table) << '\n';
  for (int row = 0; row < rows; ++row) out << line_of(world, table, row, nullptr);
  for (const OutlinePoint& point : points) out << line_of(world, table, point.body, &point);
}

}  // namespace quicksand
