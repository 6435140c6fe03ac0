// What an export contains: every column with name, unit, meaning and where it comes from, in one place.
// All formats and `quicksand list columns` are these tables.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/measures/measures.h"
#include "core/world/world.h"

namespace quicksand {

// A pair that is exported: it touches now, is bonded, or carried a force in the last step.
struct Link {
  Pair pair;
  const Contact* contact = nullptr;  // of the last step, if it had one
  const Bond* bond = nullptr;        // active or broken, if there ever was one
  bool touching = false;
};

// A straight piece of the outline of a part of a shaped body; arcs are given as a few of them.
struct OutlinePiece {
  int body = 0, part = 0;
  Vec2 from{0, 0}, to{0, 0};  // [d]
};

struct Rectangle {
  Vec2 low{0, 0}, high{0, 0};  // corners [d]
};

// A world with what is derived from it for an export. The world must outlive it, unchanged.
class ExportedWorld {
 public:
  explicit ExportedWorld(const World& world);

  const World& world;
  const std::vector<Pair> touching;          // sorted
  const NeighbourCounts counts;              // (nd)
  const std::vector<double> pressure;        // (nd) [F_g/d]
  const std::vector<Link> links;             // sorted by pair
  const std::vector<OutlinePiece> outlines;  // part by part, counter-clockwise
  const Rectangle covered;                   // by box and disks

  Vec2 place(int disk) const;           // centre, inside periodic sides [d]
  Vec2 branch(const Link& link) const;  // from the centre of a to that of b, or to the wall [d]
  Vec2 wall_end(int wall, int which) const;  // where a picture lets the wall begin and end [d]
};

// A number, or a vector (x, y), of each row.
struct DataColumn {
  enum class Kind : std::uint8_t { real, integer };

  std::string_view name;
  std::string_view unit;  // "1" if none
  std::string_view help;
  Kind kind = Kind::real;
  int size = 1;                                                   // 2: a vector
  double (*get)(const ExportedWorld& e, int row, int component);  // integers, too, below 2^53
};

struct DataTable {
  std::string_view name;  // of its files, too
  std::string_view help;
  std::span<const DataColumn> columns;
  int (*rows)(const ExportedWorld& e);
  int corners = 1;  // how a picture shows a row: 1 a point, 2 a line
  Vec2 (*corner)(const ExportedWorld& e, int row, int which);  // [d]
};

// Name of the column that repeats the corner of a point.
inline constexpr std::string_view kPosition = "position";

// The disks, the contacts, the walls, the outlines.
std::span<const DataTable> tables();
const DataTable& disk_table();

// What there is once in a state: its time, its box. Rows are no points of a picture.
const DataTable& state_table();

// "velocity_x" for a component of a vector, otherwise the column's name.
std::string component_name(const DataColumn& column, int component);

// Appends the shortest text that reads back as the same number.
void append_text(std::string& text, const DataColumn& column, double value);

// The eight bytes of a value as a number of its kind: a double or a 64-bit integer.
std::uint64_t word_of(const DataColumn& column, double value);

}  // namespace quicksand
