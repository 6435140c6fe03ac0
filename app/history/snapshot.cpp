#include "app/history/snapshot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/bodies/sorted_cursor.h"
#include "core/checkpoint/check.h"
#include "core/checkpoint/checkpoint.h"

namespace quicksand {

namespace {

// A coordinate in steps of 2^-exponent [d]: the same wherever other bodies are, but for those that no integer of that
// step reaches. High bytes that do not vary take no place once they are packed.
constexpr int kExponent = 25;
constexpr int kCoordinateBits = 62;

// Bits of the flags of a pair and of a disk.
constexpr std::uint8_t kBond = 1, kBroken = 2, kInitial = 4, kContact = 8;
constexpr std::uint8_t kIntruder = 1, kFixed = 2;

// The bodies and their pairs, a column each; corners of shaped bodies have numbers of their own (shapes.h). A pair is
// the distance of its first body from that of the pair before it, and that of its second body from its first; or -1 - k
// for wall k.
struct Columns {
  int exponent = 0;
  std::vector<std::int64_t> x, y;
  std::vector<float> angle, vx, vy, spin, radius, fx, fy, torque;
  std::vector<double> density;
  std::vector<std::uint8_t> disk_flags;
  std::vector<std::int32_t> a, b;
  std::vector<std::uint8_t> pair_flags;
  std::vector<float> normal_force, tangential_force, rolling_torque;  // of those with a contact
  std::vector<double> cohesion;
  std::vector<float> trajectory_x, trajectory_y;
};

template <class Archive, class AnyColumns>
void describe_columns(Archive& archive, AnyColumns& c) {
  archive.value(c.exponent);
  archive.column(c.x), archive.column(c.y);
  archive.column(c.angle);
  archive.column(c.vx), archive.column(c.vy), archive.column(c.spin);
  archive.column(c.radius), archive.column(c.density);
  archive.column(c.fx), archive.column(c.fy), archive.column(c.torque);
  archive.column(c.disk_flags);
  archive.column(c.a), archive.column(c.b), archive.column(c.pair_flags);
  archive.column(c.normal_force), archive.column(c.tangential_force);
  archive.column(c.rolling_torque), archive.column(c.cohesion);
  archive.column(c.trajectory_x), archive.column(c.trajectory_y);
}

// Exact, and only where there are any: the last of a snapshot.
struct ShapeColumns {
  std::vector<double> corner_x, corner_y, corner_radius;
  std::vector<std::int32_t> corner_body, corner_count;
  std::vector<std::uint8_t> corner_shaft;
  std::vector<std::int32_t> body;
  std::vector<double> inertia, arm, radius;
};

template <class Archive, class AnyColumns>
void describe_shape_columns(Archive& archive, AnyColumns& c) {
  archive.column(c.corner_x), archive.column(c.corner_y), archive.column(c.corner_radius);
  archive.column(c.corner_body), archive.column(c.corner_count), archive.column(c.corner_shaft);
  archive.column(c.body), archive.column(c.inertia), archive.column(c.arm);
  archive.column(c.radius);
}

template <class Archive, class Vector>
void describe_vector(Archive& archive, Vector& v) {
  archive.value(v.x()), archive.value(v.y());
}

template <class Archive, class Law>
void archive_law(Archive& archive, Law& law) {
  const auto number = [&](auto& x) { archive.value(x); };
  optional_value(archive, law.friction, number);
  optional_value(archive, law.rolling_friction, number);
  optional_value(archive, law.cohesion_force, number);
  archive.value(law.cohesion_range);
}

template <class Archive, class AnyWall>
void archive_wall(Archive& archive, AnyWall& wall) {
  describe_vector(archive, wall.point), describe_vector(archive, wall.normal);
  describe_vector(archive, wall.velocity);
  archive.value(wall.mass), archive.value(wall.force), archive.value(wall.role);
}

// All but bodies and pairs.
template <class Archive, class AnyWorld>
void archive_scene(Archive& archive, AnyWorld& world) {
  archive.value(world.box.width), archive.value(world.box.height);
  archive.value(world.box.sides), archive.value(world.box.floor);
  optional_value(archive, world.gravity, [&](auto& g) { describe_vector(archive, g); });
  optional_value(archive, world.drag,
                 [&](auto& drag) { archive.value(drag.linear), archive.value(drag.quadratic); });
  archive_law(archive, world.grain_law);
  archive_law(archive, world.wall_law);
  archive_law(archive, world.intruder_law);
  archive.value(world.bonds.formed), archive.value(world.bonds.broken);
  archive.value(world.bonds.healed), archive.value(world.bonds.initial);
  archive.value(world.bonding), archive.value(world.rebonding);
  archive.value(world.impulse_dt), archive.value(world.time), archive.value(world.step);
  archive.value(world.trajectory.surface);
  archive.value(world.specimen);
  auto walls = static_cast<std::uint32_t>(world.walls.size());
  archive.value(walls);
  if constexpr (Archive::kReads) {
    // One by one: how many there are is only what the bytes say.
    for (std::uint32_t k = 0; k < walls; ++k) archive_wall(archive, world.walls.emplace_back());
  } else {
    for (const Wall& wall : world.walls) archive_wall(archive, wall);
  }
}

int exponent_for(const Disks& disks) {
  double extent = 0;
  for (const Vec2& centre : disks.position) extent = std::max(extent, centre.cwiseAbs().maxCoeff());
  int above = 0;
  std::frexp(extent, &above);
  return std::min(kExponent, kCoordinateBits - above);
}

float narrow(double x) { return static_cast<float>(x); }

void add_disks(const Disks& disks, Columns& c) {
  c.exponent = exponent_for(disks);
  const auto steps = [&](double x) {
    return std::int64_t{std::llround(std::ldexp(x, c.exponent))};
  };
  for (int i = 0; i < disks.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    c.x.push_back(steps(disks.position[k].x()));
    c.y.push_back(steps(disks.position[k].y()));
    c.angle.push_back(narrow(disks.angle[k]));
    c.vx.push_back(narrow(disks.velocity[k].x()));
    c.vy.push_back(narrow(disks.velocity[k].y()));
    c.spin.push_back(narrow(disks.velocity[k].z()));
    const double diameter = 2 * disks.radius[k];
    c.radius.push_back(narrow(disks.radius[k]));
    // The same number for all grains of a material, in spite of rounding.
    c.density.push_back(narrow(disks.mass[k] / (diameter * diameter)));
    c.fx.push_back(narrow(disks.applied[k].x()));
    c.fy.push_back(narrow(disks.applied[k].y()));
    c.torque.push_back(narrow(disks.applied[k].z()));
    c.disk_flags.push_back(static_cast<std::uint8_t>(
        (disks.role[k] == DiskRole::intruder ? kIntruder : 0) | (disks.fixed(i) ? kFixed : 0)));
  }
}

void add_contact(const World& world, const Contact& contact, Columns& c) {
  const double dt = world.impulse_dt > 0 ? world.impulse_dt : 1;
  c.normal_force.push_back(narrow(contact.normal_force(dt)));
  c.tangential_force.push_back(narrow(contact.impulse.y() / dt));
  c.rolling_torque.push_back(narrow(contact.impulse.z() / dt));
  c.cohesion.push_back(contact.cohesion);
}

bool acts(const Contact& contact) { return contact.cohesion != 0 || !contact.impulse.isZero(0); }

// What has a bond or a contact that acts, in the order of the pairs.
void add_pairs(const World& world, Columns& c) {
  int last_a = 0;
  const auto add = [&](Pair pair, const Bond* bond, const Contact* contact) {
    std::uint8_t flags = 0;
    if (bond != nullptr) {
      flags |= kBond;
      if (bond->state == BondState::broken) flags |= kBroken;
      if (bond->initial) flags |= kInitial;
    }
    if (contact != nullptr) {
      flags |= kContact;
      add_contact(world, *contact, c);
    }
    c.a.push_back(pair.a - last_a);
    c.b.push_back(is_wall(pair.b) ? kWallBase - 1 - pair.b : pair.b - pair.a);
    c.pair_flags.push_back(flags);
    last_a = pair.a;
  };
  SortedCursor<const Bond> bonds(world.bonds.list);
  const auto bond_alone = [&](const Bond& bond) { add(bond.pair, &bond, nullptr); };
  for (const Contact& contact : world.contacts) {
    if (!acts(contact)) continue;
    const Bond* bond = bonds.at(contact.pair, bond_alone);
    add(contact.pair, bond, &contact);
  }
  std::ranges::for_each(bonds.rest(), bond_alone);
}

void require(bool condition, const char* problem) {
  if (!condition) throw std::runtime_error(problem);
}

template <class... Columns>
bool of_size(std::size_t size, const Columns&... columns) {
  return ((columns.size() == size) && ...);
}

void take_disks(const Columns& c, Disks& disks) {
  require(of_size(c.x.size(), c.y, c.angle, c.vx, c.vy, c.spin, c.radius, c.density, c.fx, c.fy,
                  c.torque, c.disk_flags),
          "the columns of the disks differ in length");
  require(std::abs(c.exponent) < std::numeric_limits<double>::max_exponent, "invalid coordinates");
  const auto place = [&](std::int64_t steps) {
    return std::ldexp(static_cast<double>(steps), -c.exponent);
  };
  for (std::size_t k = 0; k < c.x.size(); ++k) {
    disks.add({.position = {place(c.x[k]), place(c.y[k])},
               .radius = c.radius[k],
               .density = c.density[k],
               .velocity = {c.vx[k], c.vy[k]},
               .spin = c.spin[k],
               .role = (c.disk_flags[k] & kIntruder) != 0 ? DiskRole::intruder : DiskRole::grain,
               .fixed = (c.disk_flags[k] & kFixed) != 0});
    disks.angle.back() = c.angle[k];
    disks.applied.back() = {c.fx[k], c.fy[k], c.torque[k]};
  }
}

ShapeColumns columns_of(const Shapes& shapes) {
  ShapeColumns c;
  for (const Corner& corner : shapes.corners) {
    c.corner_x.push_back(corner.place.x()), c.corner_y.push_back(corner.place.y());
    c.corner_radius.push_back(corner.radius);
    c.corner_body.push_back(corner.body), c.corner_count.push_back(corner.count);
    c.corner_shaft.push_back(corner.shaft ? 1 : 0);
  }
  for (const ShapedBody& shaped : shapes.bodies) {
    c.body.push_back(shaped.body);
    c.inertia.push_back(shaped.inertia), c.arm.push_back(shaped.arm);
    c.radius.push_back(shaped.radius);
  }
  return c;
}

void take_shapes(const ShapeColumns& c, World& world) {
  require(of_size(c.corner_x.size(), c.corner_y, c.corner_radius, c.corner_body, c.corner_count,
                  c.corner_shaft) &&
              of_size(c.body.size(), c.inertia, c.arm, c.radius),
          "the columns of the shapes differ in length");
  for (std::size_t k = 0; k < c.corner_x.size(); ++k)
    world.shapes.corners.push_back({.place = {c.corner_x[k], c.corner_y[k]},
                                    .radius = c.corner_radius[k],
                                    .body = c.corner_body[k],
                                    .count = c.corner_count[k],
                                    .shaft = c.corner_shaft[k] != 0});
  Disks& disks = world.disks;
  for (std::size_t k = 0; k < c.body.size(); ++k) {
    require(c.body[k] >= 0 && c.body[k] < disks.size(), "a shape belongs to no body");
    world.shapes.bodies.push_back(
        {.body = c.body[k], .inertia = c.inertia[k], .arm = c.arm[k], .radius = c.radius[k]});
    if (!disks.fixed(c.body[k])) disks.inverse_mass[c.body[k]].z() = 1 / c.inertia[k];
  }
}

// Their gaps and normals are those of the places.
void take_pairs(const Columns& c, World& world) {
  require(of_size(c.a.size(), c.b, c.pair_flags), "the columns of the pairs differ in length");
  require(of_size(c.cohesion.size(), c.normal_force, c.tangential_force, c.rolling_torque),
          "the columns of the contacts differ in length");
  const double dt = world.impulse_dt > 0 ? world.impulse_dt : 1;
  const std::int64_t nd = world.disks.size();
  const auto nw = static_cast<int>(world.walls.size());
  const auto nk = static_cast<std::int64_t>(world.shapes.corners.size());
  const auto known = [&](std::int64_t body) {
    return body >= 0 && (body < nd || (body >= kCornerBase && body < kCornerBase + nk));
  };
  std::int64_t a = 0;
  std::size_t contact = 0;
  for (std::size_t k = 0; k < c.a.size(); ++k) {
    a += c.a[k];
    const std::int64_t b = c.b[k] < 0 ? kWallBase - 1 - std::int64_t{c.b[k]} : a + c.b[k];
    require(known(a) && (c.b[k] < 0 ? b < kWallBase + nw : b > a && known(b)),
            "a pair does not belong to these bodies");
    const Pair pair{static_cast<int>(a), static_cast<int>(b)};
    const std::uint8_t flags = c.pair_flags[k];
    if ((flags & kBond) != 0)
      world.bonds.list.push_back(
          {.pair = pair,
           .state = (flags & kBroken) != 0 ? BondState::broken : BondState::active,
           .initial = (flags & kInitial) != 0});
    if ((flags & kContact) == 0) continue;
    require(contact < c.cohesion.size(), "it has too few contacts");
    Contact made{.pair = pair, .cohesion = c.cohesion[contact]};
    made.impulse = Vec3(c.normal_force[contact] + made.cohesion, c.tangential_force[contact],
                        c.rolling_torque[contact]) *
                   dt;
    world.contacts.push_back(made);
    ++contact;
  }
  require(contact == c.cohesion.size(), "it has too many contacts");
}

}  // namespace

Bytes snapshot_of(const World& world) {
  Columns columns;
  add_disks(world.disks, columns);
  add_pairs(world, columns);
  for (const Vec2& place : world.trajectory.places) {
    columns.trajectory_x.push_back(narrow(place.x()));
    columns.trajectory_y.push_back(narrow(place.y()));
  }
  ColumnWriter writer;
  archive_scene(writer, world);
  describe_columns(writer, std::as_const(columns));
  if (!world.shapes.empty()) {
    const ShapeColumns shapes = columns_of(world.shapes);
    describe_shape_columns(writer, shapes);
  }
  return writer.bytes();
}

World world_from_snapshot(std::span<const std::uint8_t> bytes) {
  ColumnReader reader(bytes);
  Checkpoint checked;
  World& world = checked.world;
  Columns columns;
  archive_scene(reader, world);
  describe_columns(reader, columns);
  ShapeColumns shapes;
  if (!reader.at_end()) describe_shape_columns(reader, shapes);
  require(reader.at_end(), "it is too long");
  take_disks(columns, world.disks);
  take_shapes(shapes, world);
  take_pairs(columns, world);
  require(of_size(columns.trajectory_x.size(), columns.trajectory_y), "invalid trajectory");
  for (std::size_t k = 0; k < columns.trajectory_x.size(); ++k)
    world.trajectory.places.emplace_back(columns.trajectory_x[k], columns.trajectory_y[k]);
  if (const char* problem = inconsistency(checked)) throw std::runtime_error(problem);
  for (Contact& contact : world.contacts) contact.gap = world.gap(contact.pair, &contact.normal);
  return std::move(world);
}

}  // namespace quicksand
