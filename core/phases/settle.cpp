// The phase "settle": nothing is added.
#include "core/phases/protocol.h"

namespace quicksand {

void Protocol::enter(const SettlePhase& phase) { form_bonds(phase.bonding, phase.bonds); }

bool Protocol::is_over(const SettlePhase& phase) {
  return lasted(phase.max_time) || (phase.until_rest && at_rest(phase.rest_speed, phase.rest_time));
}

double Protocol::progress(const SettlePhase& phase) const {
  return (world_.time - state_.phase_start) / phase.max_time;
}

}  // namespace quicksand
