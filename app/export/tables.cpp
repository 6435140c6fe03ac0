#include "app/export/tables.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

namespace quicksand {

namespace {

using E = ExportedWorld;
using enum DataColumn::Kind;

const Link& link(const E& e, int row) { return e.links[static_cast<std::size_t>(row)]; }

const Wall& wall(const E& e, int row) { return e.world.walls[static_cast<std::size_t>(row)]; }

// Part k of the impulse over the step that it belongs to; 0 before the first step.
double mean_force(const E& e, int row, int k) {
  const Contact* contact = link(e, row).contact;
  return contact != nullptr ? contact->impulse[k] / e.world.impulse_dt : 0;
}

double cohesion(const E& e, int row) {
  const Contact* contact = link(e, row).contact;
  return contact != nullptr ? contact->cohesion : 0;
}

Vec2 present_normal(const E& e, int row) {
  Vec2 normal;
  e.world.gap(link(e, row).pair, &normal);
  return normal;
}

constexpr DataColumn kDiskColumns[] = {
    {"disk", "1", "number of the disk, from 0", integer, 1,
     [](const E&, int row, int) -> double { return row; }},
    {kPosition, "d", "centre, inside periodic sides", real, 2,
     [](const E& e, int row, int k) { return e.place(row)[k]; }},
    {"unwrapped_x", "d", "x of the centre, counting all passages through periodic sides", real, 1,
     [](const E& e, int row, int) { return e.world.disks.position[row].x(); }},
    {"radius", "d", "radius of the disk", real, 1,
     [](const E& e, int row, int) { return e.world.disks.radius[row]; }},
    {"mass", "grain masses", "mass of the disk", real, 1,
     [](const E& e, int row, int) { return e.world.disks.mass[row]; }},
    {"angle", "rad", "rotation since it was placed, counter-clockwise", real, 1,
     [](const E& e, int row, int) { return e.world.disks.angle[row]; }},
    {"velocity", "sqrt(g d)", "velocity of the centre", real, 2,
     [](const E& e, int row, int k) { return e.world.disks.velocity[row][k]; }},
    {"spin", "sqrt(g/d)", "angular velocity, counter-clockwise", real, 1,
     [](const E& e, int row, int) { return e.world.disks.velocity[row].z(); }},
    {"speed", "sqrt(g d)", "speed of the centre", real, 1,
     [](const E& e, int row, int) { return e.world.disks.velocity[row].head<2>().norm(); }},
    {"applied_force", "F_g", "force in addition to gravity, contacts and drag", real, 2,
     [](const E& e, int row, int k) { return e.world.disks.applied[row][k]; }},
    {"applied_torque", "F_g d", "torque in addition to that of contacts", real, 1,
     [](const E& e, int row, int) { return e.world.disks.applied[row].z(); }},
    {"pressure", "F_g/d", "compressive normal forces over the circumference", real, 1,
     [](const E& e, int row, int) { return e.pressure[static_cast<std::size_t>(row)]; }},
    {"role", "1", "0 grain, 1 intruder", integer, 1,
     [](const E& e, int row, int) {
       return e.world.disks.role[row] == DiskRole::intruder ? 1.0 : 0.0;
     }},
    {"fixed", "1", "1: moves as prescribed, whatever acts on it", integer, 1,
     [](const E& e, int row, int) { return e.world.disks.fixed(row) ? 1.0 : 0.0; }},
    {"contacts", "1", "touching neighbours, including walls", integer, 1,
     [](const E& e, int row, int) -> double { return e.counts.touching[row]; }},
    {"loaded_contacts", "1", "contacts that carry a compressive force or a bond", integer, 1,
     [](const E& e, int row, int) -> double { return e.counts.loaded[row]; }},
    {"active_bonds", "1", "bonds that have not broken", integer, 1,
     [](const E& e, int row, int) -> double { return e.counts.active[row]; }},
    {"broken_bonds", "1", "bonds that broke and were not healed", integer, 1,
     [](const E& e, int row, int) -> double { return e.counts.broken[row]; }},
    {"initial_bonds", "1", "initial bonds with disks and walls, active or broken", integer, 1,
     [](const E& e, int row, int) -> double { return e.counts.initial[row]; }},
};

constexpr DataColumn kContactColumns[] = {
    {"a", "1", "number of the disk from which the normal points", integer, 1,
     [](const E& e, int row, int) -> double { return e.world.row(link(e, row).pair.a); }},
    {"b", "1", "number of the disk to which the normal points; -1: a wall", integer, 1,
     [](const E& e, int row, int) -> double {
       const int b = e.world.row(link(e, row).pair.b);
       return is_wall(b) ? -1 : b;
     }},
    {"wall", "1", "number of the wall; -1: b is a disk", integer, 1,
     [](const E& e, int row, int) -> double {
       const int b = link(e, row).pair.b;
       return is_wall(b) ? b - kWallBase : -1;
     }},
    {"touching", "1", "1: the gap is at most the cohesion range, or 5e-5 d without cohesion",
     integer, 1, [](const E& e, int row, int) { return link(e, row).touching ? 1.0 : 0.0; }},
    {"bond", "1", "0 never bonded, 1 active, 2 broken", integer, 1,
     [](const E& e, int row, int) {
       const Bond* bond = link(e, row).bond;
       if (bond == nullptr) return 0.0;
       return bond->state == BondState::active ? 1.0 : 2.0;
     }},
    {"initial", "1",
     "1: the bond is an initial bond; broken ones of pairs that are apart have no row, so shares "
     "of "
     "initial bonds follow from the table of states",
     integer, 1,
     [](const E& e, int row, int) {
       const Bond* bond = link(e, row).bond;
       return bond != nullptr && bond->initial ? 1.0 : 0.0;
     }},
    {"gap", "d", "current gap, positive when apart", real, 1,
     [](const E& e, int row, int) { return e.world.gap(link(e, row).pair); }},
    {"branch", "d",
     "from the centre of a to that of b, or to the point of contact with a wall or shaped body",
     real, 2, [](const E& e, int row, int k) { return e.branch(link(e, row))[k]; }},
    {"normal", "1", "current unit vector from a to b", real, 2,
     [](const E& e, int row, int k) { return present_normal(e, row)[k]; }},
    {"force", "F_g", "force on b in the last step, along that step's normal and tangent", real, 2,
     [](const E& e, int row, int k) {
       const Contact* contact = link(e, row).contact;
       return contact != nullptr ? contact->force(e.world.impulse_dt)[k] : 0;
     }},
    {"normal_force", "F_g", "R_n = N - F_c, compression positive", real, 1,
     [](const E& e, int row, int) { return mean_force(e, row, 0) - cohesion(e, row); }},
    {"tangential_force", "F_g", "R_t on b, along the normal turned by +90 degrees", real, 1,
     [](const E& e, int row, int) { return mean_force(e, row, 1); }},
    {"rolling_torque", "F_g d", "T on b, counter-clockwise", real, 1,
     [](const E& e, int row, int) { return mean_force(e, row, 2); }},
    {"cohesion", "F_g", "F_c where the bond was active in the last step, otherwise 0", real, 1,
     [](const E& e, int row, int) { return cohesion(e, row); }},
};

constexpr DataColumn kWallColumns[] = {
    {"wall", "1", "number of the wall, from 0", integer, 1,
     [](const E&, int row, int) -> double { return row; }},
    {"point", "d", "a point on its surface", real, 2,
     [](const E& e, int row, int k) { return wall(e, row).point[k]; }},
    {"normal", "1", "unit vector into the free side", real, 2,
     [](const E& e, int row, int k) { return wall(e, row).normal[k]; }},
    {"velocity", "sqrt(g d)", "velocity of the wall", real, 2,
     [](const E& e, int row, int k) { return wall(e, row).velocity[k]; }},
    {"mass", "grain masses", "mass of the wall; 0: it moves as prescribed", real, 1,
     [](const E& e, int row, int) { return wall(e, row).mass; }},
    {"force", "F_g", "force along the normal, on a wall with mass", real, 1,
     [](const E& e, int row, int) { return wall(e, row).force; }},
    {"role", "1", "0 floor, 1 side, 2 piston", integer, 1,
     [](const E& e, int row, int) { return static_cast<double>(wall(e, row).role); }},
};

const OutlinePiece& piece(const E& e, int row) { return e.outlines[static_cast<std::size_t>(row)]; }

constexpr DataColumn kOutlineColumns[] = {
    {"body", "1", "number of the disk that stands for the body", integer, 1,
     [](const E& e, int row, int) -> double { return piece(e, row).body; }},
    {"part", "1", "number of the convex part, from 0", integer, 1,
     [](const E& e, int row, int) -> double { return piece(e, row).part; }},
    {"from", "d", "where the piece begins", real, 2,
     [](const E& e, int row, int k) { return piece(e, row).from[k]; }},
    {"to", "d", "where it ends", real, 2,
     [](const E& e, int row, int k) { return piece(e, row).to[k]; }},
};

constexpr DataColumn kStateColumns[] = {
    {"time", "sqrt(d/g)", "time since the beginning", real, 1,
     [](const E& e, int, int) { return e.world.time; }},
    {"step", "1", "time steps since the beginning", integer, 1,
     [](const E& e, int, int) { return static_cast<double>(e.world.step); }},
    {"box", "d", "width and height of the box", real, 2,
     [](const E& e, int, int k) { return k == 0 ? e.world.box.width : e.world.box.height; }},
    {"periodic", "1", "1: the sides of the box are periodic", integer, 1,
     [](const E& e, int, int) { return e.world.box.sides == Sides::periodic ? 1.0 : 0.0; }},
    {"initial_bonds", "1", "initial bonds, active or broken, whether their pairs touch or not",
     integer, 1, [](const E& e, int, int) { return static_cast<double>(e.world.bonds.initial); }},
    {"initial_bonds_active", "1", "those of them that are active: over them, the remaining share",
     integer, 1,
     [](const E& e, int, int) {
       return static_cast<double>(std::ranges::count_if(e.world.bonds.list, [](const Bond& bond) {
         return bond.initial && bond.state == BondState::active;
       }));
     }},
};

constexpr DataTable kTables[] = {
    {"disks", "grains and intruders", kDiskColumns, [](const E& e) { return e.world.disks.size(); },
     1, [](const E& e, int row, int) { return e.place(row); }},
    {"contacts", "pairs that touch, are bonded, or carried a force in the last step",
     kContactColumns, [](const E& e) { return static_cast<int>(e.links.size()); }, 2,
     [](const E& e, int row, int which) {
       const Link& l = link(e, row);
       const Vec2 from = e.place(e.world.row(l.pair.a));
       return which == 0 ? from : Vec2(from + e.branch(l));
     }},
    {"walls", "straight walls, as lines as long as the packing is wide or high", kWallColumns,
     [](const E& e) { return static_cast<int>(e.world.walls.size()); }, 2,
     [](const E& e, int row, int which) { return e.wall_end(row, which); }},
    {"outlines", "intruders of several parts: the outline of each part in straight pieces",
     kOutlineColumns, [](const E& e) { return static_cast<int>(e.outlines.size()); }, 2,
     [](const E& e, int row, int which) {
       return which == 0 ? piece(e, row).from : piece(e, row).to;
     }},
};

constexpr DataTable kStates{
    "states", "one row per state", kStateColumns, [](const E&) { return 1; }, 0, nullptr};

}  // namespace

std::span<const DataTable> tables() { return kTables; }

const DataTable& disk_table() { return kTables[0]; }

const DataTable& state_table() { return kStates; }

std::string component_name(const DataColumn& column, int component) {
  const std::string name(column.name);
  return column.size == 1 ? name : name + (component == 0 ? "_x" : "_y");
}

void append_text(std::string& text, const DataColumn& column, double value) {
  std::array<char, 32> digits{};
  char* const end = digits.data() + digits.size();
  const auto written = column.kind == integer
                           ? std::to_chars(digits.data(), end, static_cast<std::int64_t>(value))
                           : std::to_chars(digits.data(), end, value);
  text.append(digits.data(), written.ptr);
}

std::uint64_t word_of(const DataColumn& column, double value) {
  return column.kind == integer ? static_cast<std::uint64_t>(static_cast<std::int64_t>(value))
                                : std::bit_cast<std::uint64_t>(value);
}

}  // namespace quicksand
