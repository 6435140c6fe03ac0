// The phase "settle": nothing is added.
#include "core/protocol/running_phase.h"

namespace quicksand {

namespace {

class Settle final : public RunningPhaseOf<SettlePhase> {
 public:
  using RunningPhaseOf::RunningPhaseOf;

  void begin(Stage& stage) override { stage.form_bonds(settings().bonding, settings().bonds); }
  bool finished(Stage& stage) override {
    return stage.lasted(settings().max_time) ||
           (settings().until_rest && stage.at_rest(settings().rest_speed, settings().rest_time));
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const SettlePhase& settings) {
  return std::make_unique<Settle>(settings);
}

}  // namespace quicksand
