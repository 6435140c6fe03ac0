// The phase "slide": the piston that presses on the packing slides along x, at a speed.
#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/forces/wall_loads.h"
#include "core/phases/drive.h"

namespace quicksand {

namespace {

// Index of the last piston; -1: there is none.
int piston_in(const World& world) {
  for (int k = static_cast<int>(world.walls.size()) - 1; k >= 0; --k)
    if (is_pressing_piston(world.walls[static_cast<std::size_t>(k)])) return k;
  return -1;
}

// Of a world, constant or not, that has one.
auto& piston_of(auto& world) { return world.walls[static_cast<std::size_t>(piston_in(world))]; }

class Slide final : public RunningPhaseOf<SlidePhase> {
 public:
  explicit Slide(const SlidePhase& phase)
      : RunningPhaseOf(phase),
        setup_{.drive = Drive::slide,
               .search = SearchKind::none,
               .direction = {std::copysign(1.0, phase.speed), 0, 0},
               .rate = std::abs(phase.speed),
               .load = 0,
               .whole = phase.distance,
               .window = 0.1} {}

  void begin(Stage& stage) override {
    World& world = stage.world;
    if (piston_in(world) < 0)
      throw InputError("phases[" + std::to_string(stage.state.phase) + "]",
                       "needs a piston that presses on the packing, but there is none");
    stage.form_bonds(settings().bonding, settings().bonds);
    if (world.bonds.initial == 0) world.bonds.mark_initial();
    stage.state.memory["start"] = piston_of(world).point.x();
    begin_way(stage, 0);
  }

  void before_step(Stage& stage) override {
    Wall& piston = piston_of(stage.world);
    piston.velocity.x() =
        ramp_share(stage, settings().ramp_time) * *setup_.rate * setup_.direction.x();
  }

  bool finished(Stage& stage) override {
    const double way = way_of(stage);
    if (const double time = take_unrecorded_time(stage); time > 0) {
      const Vec2 force = force_on_wall(stage.world, piston_in(stage.world));
      record_load(stage, setup_, -force.x() * setup_.direction.x(), time, way);
    }
    return way >= setup_.whole * (1 - kRounding);
  }

  void end(Stage& stage) override {
    World& world = stage.world;
    Wall& piston = piston_of(world);
    const double weight = world.gravity ? piston.mass * world.gravity->dot(piston.normal) : 0;
    keep_account(stage, setup_, way_of(stage), {.normal_load = piston.force + weight});
    piston.velocity.x() = 0;
  }

  double progress(const Stage& stage) const override { return way_of(stage) / setup_.whole; }
  bool missed_rest(const Stage&) const override { return false; }

 private:
  // Of sums of a step's ways, relative.
  static constexpr double kRounding = 1e-9;

  double way_of(const Stage& stage) const {
    return (piston_of(stage.world).point.x() - stage.state.memory.at("start")) *
           setup_.direction.x();
  }

  DriveSetup setup_;
};

}  // namespace

std::unique_ptr<RunningPhase> running(const SlidePhase& settings) {
  return std::make_unique<Slide>(settings);
}

}  // namespace quicksand
