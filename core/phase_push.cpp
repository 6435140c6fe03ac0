// The phase "push": an intruder is pushed into the packing.
#include "core/ballistic.h"
#include "core/protocols.h"

namespace quicksand {

void Protocol::enter(const PushPhase& phase) {
  world_.bonding = phase.bonding;
  world_.bonds.mark_initial();
  const double radius = phase.diameter / 2;
  const double x = phase.x.value_or(world_.box.width / 2);
  const std::optional<Landing> landing = LandingSite(world_).land(x, radius);
  const int intruder = world_.disks.add({.position = landing ? landing->centre : Vec2(x, radius),
                                         .radius = radius,
                                         .density = phase.density,
                                         .role = Role::intruder});
  world_.disks.applied[intruder] = {0, -phase.force, 0};
}

// The intruder is the last disk as long as its phase lasts.
bool Protocol::is_over(const PushPhase& phase) {
  const double speed = world_.disks.velocity.back().head<2>().norm();
  const bool rest = phase.until == RestOf::driven
                        ? rested(speed <= phase.rest_speed, phase.rest_time)
                        : at_rest(phase.rest_speed, phase.rest_time);
  return rest || lasted(phase.max_time);
}

double Protocol::progress(const PushPhase& phase) const {
  return (world_.time - state_.phase_start) / phase.max_time;
}

void Protocol::leave(const PushPhase& phase) {
  if (phase.release) world_.disks.applied.back() = {0, 0, 0};
}

}  // namespace quicksand
