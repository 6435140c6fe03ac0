// The phase "piston": a horizontal wall with mass presses from above. Its force rises linearly in time.
#include <algorithm>

#include "core/protocols.h"

namespace quicksand {

namespace {

// The top of all bodies, intruders included [d].
double highest_point(const Disks& disks) {
  double top = 0;
  for (int i = 0; i < disks.size(); ++i)
    top = std::max(top, disks.position[i].y() + disks.radius[i]);
  return top;
}

}  // namespace

void Protocol::enter(const PistonPhase& phase) {
  world_.bonding = phase.bonding;
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
