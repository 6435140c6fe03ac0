// The phase "piston": a horizontal wall with mass presses from above. Its force rises or falls linearly in time.
#include <optional>

#include "core/measures/measures.h"
#include "core/protocol/running_phase.h"
#include "core/world/extent.h"

namespace quicksand {

namespace {

// Whether the bodies fill this share of the room between the floor and the piston; also where there is no room left.
bool is_filled(const World& world, double share) {
  const double bottom = packing_bottom(world), top = world.walls.back().point.y();
  return top <= bottom || volume_fraction(world, bottom, top) >= share;
}

// The piston is the last wall as long as its phase lasts.
class Piston final : public RunningPhaseOf<PistonPhase> {
 public:
  using RunningPhaseOf::RunningPhaseOf;

  void begin(Stage& stage) override {
    World& world = stage.world;
    stage.form_bonds(settings().bonding, settings().bonds);
    if (world.bonds.initial == 0) world.bonds.mark_initial();
    if (world.walls.empty() || !is_pressing_piston(world.walls.back()))
      world.walls.push_back(
          {.point = {0, highest_point(world)}, .normal = {0, -1}, .role = WallRole::piston});
    world.walls.back().mass = settings().mass;
    stage.state.memory["force_before"] = world.walls.back().force;
  }

  bool can_go_on(const Stage& stage) const override {
    const std::vector<Wall>& walls = stage.world.walls;
    return !walls.empty() && is_pressing_piston(walls.back());
  }

  void before_step(Stage& stage) override {
    const double ramp = settings().ramp_time, force = settings().force;
    const double before = stage.state.memory["force_before"];
    const bool full = ramp == 0 || stage.lasted(ramp);
    stage.world.walls.back().force =
        full ? force : before + (force - before) * stage.since_start() / ramp;
  }

  bool finished(Stage& stage) override {
    if (stage.lasted(settings().max_time)) return true;
    const std::optional<double>& filled = settings().volume_fraction;
    if (filled && is_filled(stage.world, *filled)) return true;
    if (!stage.lasted(settings().ramp_time)) return false;  // rest counts from the end of the ramp
    if (settings().until == RestOf::all)
      return stage.at_rest(settings().rest_speed, settings().rest_time);
    const double speed = stage.world.walls.back().velocity.norm();
    return stage.rested(speed <= settings().rest_speed, settings().rest_time);
  }

  void end(Stage& stage) override {
    if (settings().remove) remove_last_wall(stage.world);
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const PistonPhase& settings) {
  return std::make_unique<Piston>(settings);
}

}  // namespace quicksand
