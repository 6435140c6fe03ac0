// The phase "heal": broken or missing bonds are restored at the contacts that are there. Bonds that
// wait heal like radioactive nuclei decay, each by itself at the rate 1/healing_time.
#include <cmath>
#include <vector>

#include "core/protocol/running_phase.h"

namespace quicksand {

namespace {

class Heal final : public RunningPhaseOf<HealPhase> {
 public:
  using RunningPhaseOf::RunningPhaseOf;

  void begin(Stage& stage) override {
    const auto& [which, waited, healing_time] = settings();
    const double chance = waited ? -std::expm1(-*waited / *healing_time) : 1;
    World& world = stage.world;
    std::vector<Pair> healed;
    for (const Pair& pair : bondable_pairs(world)) {
      const Bond* bond = world.bonds.find(pair);
      const bool candidate =
          bond ? bond->state == BondState::broken : which == HealPhase::Which::touching;
      if (candidate && (!waited || world.random.uniform() < chance)) healed.push_back(pair);
    }
    world.bonds.heal(healed);
  }
  bool finished(Stage&) override { return true; }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const HealPhase& settings) {
  return std::make_unique<Heal>(settings);
}

}  // namespace quicksand
