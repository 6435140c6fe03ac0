// The phase "piston": a horizontal wall with mass presses from above. Its force rises linearly in time.
#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>

#include "core/phases/protocol.h"

namespace quicksand {

namespace {

// The top of all bodies, intruders included; 0 if there are none [d].
double highest_point(const Disks& disks) {
  std::optional<double> top;
  for (int i = 0; i < disks.size(); ++i) {
    const double of_disk = disks.position[i].y() + disks.radius[i];
    top = std::max(top.value_or(of_disk), of_disk);
  }
  return top.value_or(0);
}

// Share of the box below the piston that the disks fill; infinite where there is no room left.
double filled_below(const World& world) {
  double area = 0;
  for (const double r : world.disks.radius) area += std::numbers::pi * r * r;
  const double room = world.box.width * world.walls.back().point.y();
  return room > 0 ? area / room : std::numeric_limits<double>::infinity();
}

}  // namespace

void Protocol::enter(const PistonPhase& phase) {
  form_bonds(phase.bonding, phase.bonds);
  if (world_.bonds.initial == 0) world_.bonds.mark_initial();
  world_.walls.push_back({.point = {0, highest_point(world_.disks)},
                          .normal = {0, -1},
                          .mass = phase.mass,
                          .role = WallRole::piston});
}

// The piston is the last wall as long as its phase lasts.
void Protocol::before_step(const PistonPhase& phase) {
  const double since = world_.time - state_.phase_start;
  const bool full = phase.ramp_time == 0 || lasted(phase.ramp_time);
  world_.walls.back().force = full ? phase.force : phase.force * since / phase.ramp_time;
}

bool Protocol::is_over(const PistonPhase& phase) {
  if (lasted(phase.max_time)) return true;
  if (phase.volume_fraction && filled_below(world_) >= *phase.volume_fraction) return true;
  if (!lasted(phase.ramp_time)) return false;  // rest counts from the end of the ramp
  const double speed = world_.walls.back().velocity.norm();
  return phase.until == RestOf::driven ? rested(speed <= phase.rest_speed, phase.rest_time)
                                       : at_rest(phase.rest_speed, phase.rest_time);
}

double Protocol::progress(const PistonPhase& phase) const {
  return (world_.time - state_.phase_start) / phase.max_time;
}

void Protocol::leave(const PistonPhase& phase) {
  if (phase.remove) remove_last_wall(world_);
}

}  // namespace quicksand
