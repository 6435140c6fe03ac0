#include "core/drives/drive.h"

#include <algorithm>

#include "core/base/errors.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

void require_no_intruder(const Stage& stage) {
  if (stage.world.intruder() < 0) return;
  throw InputError("phases[" + std::to_string(stage.state.phase) + "]",
                   "brings an intruder, and the state that it begins with has one");
}

double ramp(const Stage& stage, double ramp_time) {
  return ramp_time == 0 ? 1 : std::min(1.0, stage.since_start() / ramp_time);
}

void set_free(World& world, int body) {
  Disks& disks = world.disks;
  const ShapedBody* shaped = world.shapes.find(body);
  const double inertia = shaped ? shaped->inertia : disks.inertia(body);
  disks.inverse_mass[body] = {1 / disks.mass[body], 1 / disks.mass[body], 1 / inertia};
}

void prescribe(World& world, int body, const Vec3& velocity) {
  world.disks.inverse_mass[body].setZero();
  world.disks.velocity[body] = velocity;
}

void begin_way(Stage& stage, double way) {
  auto& memory = stage.state.memory;
  memory["way_begins"] = memory["way_before"] = way;
}

double take_unrecorded_time(Stage& stage) {
  double& recorded = stage.state.memory["recorded"];
  const double time = stage.world.time - std::max(recorded, stage.state.phase_start);
  recorded = stage.world.time;
  return time;
}

void record_load(Stage& stage, double load, double time, double way, double whole, double window) {
  auto& memory = stage.state.memory;
  double& before = memory["way_before"];
  memory["work"] += load * (way - before);
  before = way;
  memory["window_load"] += time * load;
  memory["window_time"] += time;
  constexpr double kLate = 0.75;  // of the way
  if (way >= kLate * whole) {
    memory["late_load"] += time * load;
    memory["late_time"] += time;
  }
  if (way < memory["window_begin"] + window) return;
  const double mean = memory["window_load"] / memory["window_time"];
  if (mean > memory["peak"]) {
    memory["peak"] = mean;
    memory["peak_at"] = way;
  }
  memory["window_begin"] = way;
  memory["window_load"] = memory["window_time"] = 0;
}

DriveResult drive_result(const Stage& stage, Drive drive, double way, int body) {
  const auto& memory = stage.state.memory;
  const auto number = [&](const char* key) {
    const auto found = memory.find(key);
    return found == memory.end() ? 0 : found->second;
  };
  const double late = number("late_time"), driven = way - number("way_begins");
  return {.phase = stage.state.phase,
          .drive = drive,
          .peak = number("peak"),
          .peak_at = number("peak_at"),
          .residual = late > 0 ? number("late_load") / late : 0,
          .mean = driven > 0 ? number("work") / driven : 0,
          .way = way,
          .radius = reach_of(stage.world, body),
          .cleared = static_cast<std::int64_t>(number("cleared"))};
}

}  // namespace quicksand
