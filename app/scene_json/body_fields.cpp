// Explicitly listed bodies, as fields of a scene file. An entry may stand for a row of bodies.
#include "app/scene_json/scene_fields.h"
#include "core/base/memory.h"

namespace quicksand {

namespace {

constexpr std::string_view kRoles[] = {"grain", "intruder"};

constexpr double kLongestOffset = 1e6;  // [d]
// Memory that a listed body takes until its overlaps are checked. [bytes]
constexpr double kBytesToList = 500;

struct Repeat {
  std::int64_t count = 1;
  Vec2 offset{1, 0};  // [d]
};

struct BodyEntry {
  Disk disk;
  Vec2 force{0, 0};   // [F_g]
  double torque = 0;  // [F_g d]
  std::optional<Repeat> repeat;
};

void describe_repeat(Fields& f, Repeat& repeat) {
  using enum Presence;
  f.integer({"count", "number of bodies, this one included", required}, 1, kMaxBodies,
            repeat.count);
  f.vector({"offset", "offset from each body to the next", required},
           between(-kLongestOffset, kLongestOffset, "d"), repeat.offset);
}

Vec2 place_in_row(const BodyEntry& entry, std::int64_t k) {
  return entry.disk.position + static_cast<double>(k) * entry.repeat.value_or(Repeat{}).offset;
}

void describe_entry(Fields& f, BodyEntry& e) {
  constexpr double kRadius = 0.5;
  const Limits place = between(-1e7, 1e7, "d");
  f.vector({"position", "position of the centre", Presence::required}, place, e.disk.position);
  f.number({"diameter", "diameter of the disk"}, above(0, 1e4, "d", kRadius), e.disk.radius);
  f.number({"density", "density relative to that of a grain"}, above(0, 1e6, "1"), e.disk.density);
  f.vector({"velocity", "initial velocity; constant if fixed"}, between(-1e6, 1e6, "sqrt(g d)"),
           e.disk.velocity);
  f.number({"spin", "angular velocity, counter-clockwise"}, between(-1e6, 1e6, "sqrt(g/d)"),
           e.disk.spin);
  f.vector({"force", "applied force, in addition to gravity"}, between(-1e12, 1e12, "F_g"),
           e.force);
  f.number({"torque", "applied torque, counter-clockwise"}, between(-1e12, 1e12, "F_g d"),
           e.torque);
  f.choice({"role", "whether it counts as a grain"}, kRoles, e.disk.role);
  f.flag({"fixed", "moves at its given velocity, whatever acts on it"}, e.disk.fixed);
  f.optional_object({"repeat", "places a row of such bodies"}, e.repeat, describe_repeat);
  if (!f.reading()) return;
  const char* idle = e.force != Vec2(0, 0) ? "force" : e.torque != 0 ? "torque" : nullptr;
  if (e.disk.fixed && idle)
    f.refuse(idle, "acts on a fixed body, which moves with its velocity, whatever acts on it");
  if (!e.repeat) return;
  const Vec2 last = place_in_row(e, e.repeat->count - 1);
  f.require_within("repeat", "the last position[0]", place, last.x());
  f.require_within("repeat", "the last position[1]", place, last.y());
}

bool same_but_for_place(const Disk& a, const Disk& b) {
  return a.radius == b.radius && a.density == b.density && a.velocity == b.velocity &&
         a.spin == b.spin && a.role == b.role && a.fixed == b.fixed;
}

// How many bodies from `first` on are a row: the same but for places that a repeat gives back bit by bit.
std::int64_t row_length(const std::vector<Disk>& disks, const std::vector<Vec3>& forces,
                        std::size_t first) {
  if (first + 1 >= disks.size()) return 1;
  const Vec2 offset = disks[first + 1].position - disks[first].position;
  if (offset.lpNorm<Eigen::Infinity>() > kLongestOffset) return 1;
  std::int64_t count = 1;
  for (std::size_t k = first + 1; k < disks.size() && forces[k] == forces[first]; ++k, ++count) {
    const Vec2 expected = disks[first].position + static_cast<double>(count) * offset;
    if (disks[k].position != expected || !same_but_for_place(disks[k], disks[first])) break;
  }
  return count;
}

// Rows are written as repeats, so that a scene of a million bodies stays a file that can be read.
std::vector<BodyEntry> entries_of(const std::vector<Disk>& disks, const std::vector<Vec3>& forces) {
  constexpr std::int64_t kShortestRow = 3;
  std::vector<BodyEntry> entries;
  for (std::size_t i = 0; i < disks.size();) {
    const std::int64_t count = row_length(disks, forces, i);
    BodyEntry entry{disks[i], forces[i].head<2>(), forces[i].z(), std::nullopt};
    if (count >= kShortestRow)
      entry.repeat = Repeat{count, disks[i + 1].position - disks[i].position};
    i += entry.repeat ? static_cast<std::size_t>(count) : 1;
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace

void describe_bodies(Fields& f, std::vector<Disk>& disks, std::vector<Vec3>& forces) {
  std::vector<Vec3> all_forces = forces;
  all_forces.resize(disks.size(), Vec3(0, 0, 0));
  std::vector<BodyEntry> entries = entries_of(disks, all_forces);
  f.list({"bodies", "listed bodies"}, static_cast<std::size_t>(kMaxBodies), entries,
         describe_entry);
  if (!f.reading()) return;

  std::int64_t total = 0;
  for (const BodyEntry& entry : entries) total += entry.repeat ? entry.repeat->count : 1;
  if (total > kMaxBodies) {
    f.refuse("bodies", "are " + std::to_string(total) + " with their repeats, at most " +
                           std::to_string(kMaxBodies) + " are possible");
  }
  const std::string problem = memory_problem(kBytesToList * static_cast<double>(total));
  if (!problem.empty()) {
    f.refuse("bodies",
             "are " + std::to_string(total) + " with their repeats; listing them " + problem);
  }
  disks.clear();
  forces.clear();
  disks.reserve(static_cast<std::size_t>(total));
  forces.reserve(static_cast<std::size_t>(total));
  for (const BodyEntry& entry : entries) {
    const std::int64_t count = entry.repeat ? entry.repeat->count : 1;
    for (std::int64_t i = 0; i < count; ++i) {
      Disk disk = entry.disk;
      disk.position = place_in_row(entry, i);
      disks.push_back(disk);
      forces.emplace_back(entry.force.x(), entry.force.y(), entry.torque);
    }
  }
}

}  // namespace quicksand
