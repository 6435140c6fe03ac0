// The phase "heal": broken or missing bonds are restored at the contacts that are there. Bonds that
// wait heal like radioactive nuclei decay, each by itself at the rate 1/healing_time.
#include <cmath>

#include "core/phases/protocol.h"

namespace quicksand {

void Protocol::enter(const HealPhase& phase) {
  const double chance = phase.waited ? -std::expm1(-*phase.waited / *phase.healing_time) : 1;
  std::vector<Pair> healed;
  for (const Pair& pair : bondable_pairs(world_)) {
    const Bond* bond = world_.bonds.find(pair);
    const bool candidate =
        bond ? bond->state == BondState::broken : phase.which == HealPhase::Which::touching;
    if (candidate && (!phase.waited || world_.random.uniform() < chance)) healed.push_back(pair);
  }
  world_.bonds.heal(healed);
}

}  // namespace quicksand
