#include "core/world/world.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

#include "core/base/fnv.h"
#include "core/world/neighbors.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

const ContactLaw& World::law(Pair pair) const {
  const auto [a, b] = is_shaped(pair) ? rows(pair) : pair;
  if (disks.role[a] == DiskRole::intruder) return intruder_law;
  if (is_wall(b)) return wall_law;
  return disks.role[b] == DiskRole::intruder ? intruder_law : grain_law;
}

Vec2 World::separation(int a, int b) const {
  Vec2 s = disks.position[b] - disks.position[a];
  s.x() -= box.image_shift(s.x());
  return s;
}

double World::wrapped_x(double x) const {
  if (box.sides != Sides::periodic) return x;
  const double inside = x - box.width * std::floor(x / box.width);
  return inside < box.width ? inside : 0;
}

double World::gap(Pair pair, Vec2* normal) const {
  if (!is_disk(pair.b)) {
    if (is_shaped(pair)) {
      const ShapedContact contact = shaped_contact(*this, pair);
      if (normal) *normal = contact.normal;
      return contact.gap;
    }
    const Wall& w = wall(pair.b);
    if (normal) *normal = -w.normal;
    return w.normal.dot(disks.position[pair.a] - w.point) - disks.radius[pair.a];
  }
  const Vec2 s = separation(pair.a, pair.b);
  const double distance = s.norm();
  if (normal) *normal = distance > 0 ? Vec2(s / distance) : Vec2(0, 1);
  return distance - disks.radius[pair.a] - disks.radius[pair.b];
}

double World::gap_after(Pair pair, const std::vector<Vec3>& velocity, double dt) const {
  if (is_shaped(pair)) return shaped_contact_after(*this, pair, velocity, dt).gap;
  const Vec2 moved = dt * (velocity[velocity_row(pair.b)] - velocity[pair.a]).head<2>();
  if (is_wall(pair.b)) return gap(pair) - wall(pair.b).normal.dot(moved);
  return (separation(pair.a, pair.b) + moved).norm() - disks.radius[pair.a] - disks.radius[pair.b];
}

int World::intruder() const {
  const auto at = std::ranges::find(disks.role, DiskRole::intruder);
  return at == disks.role.end() ? -1 : static_cast<int>(at - disks.role.begin());
}

std::vector<Pair> bondable_pairs(const World& world) {
  const double widest = std::max({world.grain_law.cohesion_range, world.wall_law.cohesion_range,
                                  world.intruder_law.cohesion_range});
  std::vector<Pair> pairs = pairs_within(world, widest);
  std::erase_if(pairs, [&](Pair pair) {
    const ContactLaw& law = world.law(pair);
    return !law.cohesion_force || world.gap(pair) > law.cohesion_range || !world.movable(pair);
  });
  return pairs;
}

std::string message_name(const World& world, int body) {
  if (!is_wall(body)) return "body " + std::to_string(world.row(body));
  int k = body - kWallBase;
  if (world.box.floor && k-- == 0) return "the floor";
  if (world.box.sides == Sides::walls) {
    if (k == 0) return "the left side";
    if (k == 1) return "the right side";
    k -= 2;
  }
  const std::string listed = "walls[" + std::to_string(k) + "]";
  return world.wall(body).role == WallRole::piston ? listed + " (a piston)" : listed;
}

int pressing_piston(const World& world) {
  for (int k = static_cast<int>(world.walls.size()) - 1; k >= 0; --k)
    if (is_pressing_piston(world.walls[static_cast<std::size_t>(k)])) return k;
  return -1;
}

void remove_last_wall(World& world) {
  world.walls.pop_back();
  const int body = kWallBase + static_cast<int>(world.walls.size());
  world.bonds.initial -= std::ranges::count_if(
      world.bonds.list, [&](const Bond& bond) { return bond.pair.b == body && bond.initial; });
  std::erase_if(world.bonds.list, [&](const Bond& bond) { return bond.pair.b == body; });
  std::erase_if(world.contacts, [&](const Contact& contact) { return contact.pair.b == body; });
}

void become_another_specimen(World& world, const std::vector<std::uint64_t>& rows) {
  std::uint64_t hash = fnv1a(kFnvStart, static_cast<std::uint64_t>(world.specimen));
  hash = fnv1a(hash, static_cast<std::uint64_t>(world.step));
  for (const std::uint64_t row : rows) hash = fnv1a(hash, row);
  world.specimen = static_cast<std::int64_t>(hash);
}

bool same_but_for_time(const World& one, const World& other) {
  const auto state = [](const World& w) {
    return std::tie(w.bonding, w.rebonding, w.impulse_dt, w.gravity, w.drag, w.grain_law,
                    w.wall_law, w.intruder_law, w.box, w.walls, w.shapes, w.bonds.list, w.contacts,
                    w.disks);
  };
  return state(one) == state(other);
}

namespace {

// FNV-1a over 64-bit words, with a final mix. Plain values only: padding must not be hashed.
class Hash {
 public:
  void add(std::uint64_t word) {
    value_ = fnv1a(value_, word);
    value_ ^= value_ >> 29U;
  }
  void add(double x) {
    std::uint64_t word = 0;
    std::memcpy(&word, &x, sizeof word);
    add(word);
  }
  void add(const std::optional<double>& x) { add(x.has_value() ? 1 : 0), add(x.value_or(0)); }
  void add(const ContactLaw& law) {
    add(law.friction), add(law.rolling_friction), add(law.cohesion_force), add(law.cohesion_range);
  }
  void add(const Vec2& v) { add(v.x()), add(v.y()); }
  void add(const Vec3& v) { add(v.x()), add(v.y()), add(v.z()); }
  void add(int i) { add(static_cast<std::uint64_t>(i)); }
  void add(std::int64_t i) { add(static_cast<std::uint64_t>(i)); }
  template <class T>
  void add_all(const std::vector<T>& items) {
    add(static_cast<std::uint64_t>(items.size()));
    for (const T& item : items) add(item);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = kFnvStart;
};

}  // namespace

std::uint64_t world_hash(const World& world) {
  Hash hash;
  hash.add(world.time);
  hash.add(world.step);
  hash.add(world.random.state);
  hash.add(static_cast<int>(world.bonding) + (world.rebonding ? 2 : 0));
  if (world.sweep_random) hash.add(world.sweep_random->state);
  hash.add(world.box.width), hash.add(static_cast<int>(world.box.sides));
  hash.add(world.gravity.has_value() ? 1 : 0), hash.add(world.gravity.value_or(Vec2(0, 0)));
  if (world.drag) hash.add(world.drag->linear), hash.add(world.drag->quadratic);
  hash.add(world.grain_law), hash.add(world.wall_law), hash.add(world.intruder_law);
  hash.add(world.impulse_dt);
  hash.add_all(world.disks.position);
  hash.add_all(world.disks.angle);
  hash.add_all(world.disks.velocity);
  hash.add_all(world.disks.applied);
  hash.add_all(world.disks.radius);
  hash.add_all(world.disks.mass);
  hash.add_all(world.disks.inverse_mass);
  for (const DiskRole role : world.disks.role) hash.add(static_cast<int>(role));
  for (const Corner& corner : world.shapes.corners) {
    hash.add(corner.place), hash.add(corner.radius);
    hash.add(corner.body), hash.add(corner.count);
  }
  for (const Wall& wall : world.walls) {
    hash.add(wall.point), hash.add(wall.normal), hash.add(wall.velocity);
    hash.add(wall.mass), hash.add(wall.force);
  }
  for (const Bond& bond : world.bonds.list) {
    hash.add(bond.pair.a), hash.add(bond.pair.b);
    hash.add(static_cast<int>(bond.state)), hash.add(static_cast<int>(bond.initial));
  }
  for (const Contact& contact : world.contacts) {
    hash.add(contact.pair.a), hash.add(contact.pair.b);
    hash.add(contact.impulse), hash.add(contact.cohesion);
  }
  return hash.value();
}

}  // namespace quicksand
