// The phase "push": an intruder is pushed into the packing.
#include "core/ballistic.h"
#include "core/protocols.h"

namespace quicksand {

void Protocol::enter(const PushPhase& phase) {
  world_.bonding = phase.bonding;
  world_.bonds.mark_initial();
  const double radius = phase.diameter / 2;
  const double x = phase.x.value_or(world_.box.width / 2);
  const std::optional<Landing> landing = land(world_, x, radius);
  const int intruder = world_.disks.add({.position = landing ? landing->centre : Vec2(x, radius),
                                         .radius = radius,
                                         .density = phase.density,
                                         .role = Role::intruder});
  world_.disks.applied[intruder] = {0, -phase.force, 0};
}

bool Protocol::is_over(const PushPhase& phase) {
  return lasted(phase.max_time) || at_rest(phase.rest_speed, phase.rest_time);
}

double Protocol::progress(const PushPhase& phase) const {
  return (world_.time - state_.phase_start) / phase.max_time;
}

}  // namespace quicksand
