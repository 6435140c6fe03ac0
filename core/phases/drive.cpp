#include "core/phases/drive.h"

#include <algorithm>

#include "core/base/errors.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

void require_no_intruder(const Stage& stage) {
  if (stage.world.intruder() < 0) return;
  throw InputError("phases[" + std::to_string(stage.state.phase) + "]",
                   "brings an intruder, but the state it begins with already has one");
}

void set_free(World& world, int body) {
  Disks& disks = world.disks;
  const ShapedBody* shaped = world.shapes.find(body);
  const double inertia = shaped ? shaped->inertia : disks.inertia(body);
  disks.inverse_mass[body] = {1 / disks.mass[body], 1 / disks.mass[body], 1 / inertia};
}

void begin_way(Stage& stage, double way) {
  auto& memory = stage.state.memory;
  memory["way_begins"] = memory["way_before"] = memory["window_begin"] = way;
}

namespace {

// The body moves with this velocity, whatever acts on it.
void prescribe(World& world, int body, const Vec3& velocity) {
  world.disks.inverse_mass[body].setZero();
  world.disks.velocity[body] = velocity;
}

using Memory = std::map<std::string, double>;

void take_window(Memory& memory, double load, double time, double way) {
  const double mean = load / time;
  if (const auto peak = memory.find("peak"); peak != memory.end() && mean <= peak->second) return;
  memory["peak"] = mean;
  memory["peak_at"] = way;
}

// What is left at the end is shorter than a window, which therefore reaches back into the one before; the load counts
// as even over that.
void take_last_window(Memory& memory, double window, double way) {
  if (memory["window_time"] <= 0) return;
  const double open = way - memory["window_begin"];
  const double share = std::clamp(1 - open / window, 0.0, 1.0);
  take_window(memory, memory["window_load"] + share * memory["last_load"],
              memory["window_time"] + share * memory["last_time"], way);
}

}  // namespace

double ramp_share(const Stage& stage, double ramp_time) {
  return ramp_time == 0 ? 1 : std::min(1.0, stage.since_start() / ramp_time);
}

void keep_account(Stage& stage, const DriveSetup& setup, double way, DriveResult found) {
  Memory& memory = stage.state.memory;
  take_last_window(memory, setup.window, way);
  const auto known = [&](const char* key) -> std::optional<double> {
    const auto entry = memory.find(key);
    return entry == memory.end() ? std::nullopt : std::optional(entry->second);
  };
  const auto number = [&](const char* key) { return known(key).value_or(0); };
  const auto ratio = [](double load, double by) {
    return by > 0 ? std::optional(load / by) : std::nullopt;
  };
  found.phase = stage.state.phase;
  found.drive = setup.drive;
  found.peak = known("peak");
  found.peak_at = known("peak_at");
  found.residual = ratio(number("late_load"), number("late_time"));
  found.mean = ratio(number("work"), way - number("way_begins"));
  found.way = way;
  found.cleared = static_cast<std::int64_t>(number("cleared"));
  stage.state.drive_results.push_back(found);
}

void drive_on(Stage& stage, const DriveSetup& setup, int body, double ramp_time) {
  const double share = ramp_share(stage, ramp_time);
  if (setup.rate) return prescribe(stage.world, body, share * *setup.rate * setup.direction);
  set_free(stage.world, body);  // a session may have driven it at a rate so far
  stage.world.disks.applied[body] = share * setup.load * setup.direction;
}

namespace {

// Immovable bodies that a circle about the body, which holds it, reaches: few, so that a step looks no closer.
std::vector<int> immovable_near(const World& world, int body) {
  const Vec2& centre = world.disks.position[body];
  const double reach = reach_of(world, body);
  std::vector<int> near;
  for (int i = 0; i < world.disks.size(); ++i)
    if (i != body && !world.movable(i) &&
        world.separation(body, i).norm() < reach + reach_of(world, i))
      near.push_back(i);
  for (int w = kWallBase; w < kWallBase + static_cast<int>(world.walls.size()); ++w)
    if (!world.movable(w) && world.wall(w).normal.dot(centre - world.wall(w).point) < reach)
      near.push_back(w);
  return near;
}

// Pairs of the body and immovable ones that overlap by more than rounding.
std::vector<Pair> overlaps_of(const World& world, int body) {
  constexpr double kOverlap = 1e-9;  // [d]
  const std::vector<int> near = immovable_near(world, body);
  std::vector<Pair> pairs;
  if (near.empty()) return pairs;
  if (world.shapes.find(body)) {
    add_shaped_pairs(world, -kOverlap, pairs);
    return pairs;
  }
  for (const int other : near)
    if (const Pair pair{std::min(body, other), std::max(body, other)}; world.gap(pair) < -kOverlap)
      pairs.push_back(pair);
  return pairs;
}

// How fast the gap of a pair closes. [sqrt(g d)]
double closing_rate(const World& world, Pair pair) {
  const auto velocity_of = [&](int body) -> Vec2 {
    if (is_wall(body)) return world.wall(body).velocity;
    const Vec3& v = world.disks.velocity[world.row(body)];
    if (is_disk(body)) return v.head<2>();
    return v.head<2>() + v.z() * perpendicular(shaped_contact(world, pair).arm);
  };
  Vec2 normal;
  world.gap(pair, &normal);
  return normal.dot(velocity_of(pair.a) - velocity_of(pair.b));
}

}  // namespace

void require_free_way(const Stage& stage) {
  const World& world = stage.world;
  const int body = world.intruder();
  for (const Pair& pair : overlaps_of(world, body)) {
    if (world.movable(pair) || closing_rate(world, pair) <= 0) continue;
    const int other = world.row(pair.a) == body ? pair.b : pair.a;
    throw InputError("phases[" + std::to_string(stage.state.phase) + "]",
                     "drives the intruder at a prescribed rate into " + message_name(world, other) +
                         ", which no force can move; end its travel before that, or drive it by a "
                         "force or torque");
  }
}

double take_unrecorded_time(Stage& stage) {
  double& recorded = stage.state.memory["recorded"];
  const double time = stage.world.time - std::max(recorded, stage.state.phase_start);
  recorded = stage.world.time;
  return time;
}

void record_load(Stage& stage, const DriveSetup& setup, double load, double time, double way) {
  auto& memory = stage.state.memory;
  double& before = memory["way_before"];
  memory["work"] += load * (way - before);
  before = way;
  memory["window_load"] += time * load;
  memory["window_time"] += time;
  constexpr double kLate = 0.75;  // of the way
  const double begins = memory["way_begins"];
  if (way >= begins + kLate * (setup.whole - begins)) {
    memory["late_load"] += time * load;
    memory["late_time"] += time;
  }
  if (way < memory["window_begin"] + setup.window) return;
  take_window(memory, memory["window_load"], memory["window_time"], way);
  memory["last_load"] = memory["window_load"];
  memory["last_time"] = memory["window_time"];
  memory["window_begin"] = way;
  memory["window_load"] = memory["window_time"] = 0;
}

void end_way(Stage& stage, const DriveSetup& setup, double way, int body, bool release) {
  keep_account(stage, setup, way, {.radius = reach_of(stage.world, body)});
  if (setup.rate) prescribe(stage.world, body, {0, 0, 0});
  if (!release) return;
  stage.world.disks.applied[body] = {0, 0, 0};
  set_free(stage.world, body);
}

}  // namespace quicksand
