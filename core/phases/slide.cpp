// The phase "slide": the piston that presses on the packing slides along x, at a speed.
#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/forces/wall_loads.h"
#include "core/phases/drive.h"
#include "core/world/extent.h"

namespace quicksand {

namespace {

// Of a world, constant or not, that has one.
auto& piston_of(auto& world) {
  return world.walls[static_cast<std::size_t>(pressing_piston(world))];
}

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
               .window = phase.window} {}

  void begin(Stage& stage) override {
    World& world = stage.world;
    const std::string where = "phases[" + std::to_string(stage.state.phase) + "]";
    if (pressing_piston(world) < 0)
      throw InputError(where, "needs a piston that presses on the packing, but there is none");
    if (const double load = normal_load(world); load <= 0)
      throw InputError(where,
                       "needs a piston that presses on the packing, but the force of this one, "
                       "with its weight, is " +
                           message_number(load) + " F_g");
    stage.form_bonds(settings().bonding, settings().bonds);
    if (world.bonds.initial == 0) world.bonds.mark_initial();
    begin_account(stage);
  }

  bool can_go_on(const Stage& stage) const override {
    const auto& memory = stage.state.memory;
    return pressing_piston(stage.world) >= 0 && memory.contains("direction") &&
           memory.contains("start");
  }

  void before_step(Stage& stage) override {
    take_turn(stage);
    Wall& piston = piston_of(stage.world);
    piston.velocity.x() =
        ramp_share(stage, settings().ramp_time) * *setup_.rate * setup_.direction.x();
  }

  void after_part(Stage& stage) override {
    const double time = take_unrecorded_time(stage);
    const double force = -force_on_wall(stage.world, pressing_piston(stage.world)).x();
    stage.state.memory[kShearImpulse] += time * force;
    record_load(stage, setup_, force * setup_.direction.x(), time, way_of(stage));
  }

  bool finished(Stage& stage) override { return way_of(stage) >= setup_.whole * (1 - kRounding); }

  void end(Stage& stage) override {
    take_turn(stage);
    World& world = stage.world;
    keep_account(stage, setup_, way_of(stage),
                 {.normal_load = normal_load(world), .inertial_number = inertial_number(world)});
    piston_of(world).velocity.x() = 0;
  }

  double progress(const Stage& stage) const override { return way_of(stage) / setup_.whole; }
  bool missed_rest(const Stage&) const override { return false; }

 private:
  // Of sums of a step's ways, relative.
  static constexpr double kRounding = 1e-9;

  // One that is turned back under way begins a way of its own, at full speed where its ramp is over.
  void take_turn(Stage& stage) const {
    if (stage.state.memory.at("direction") != setup_.direction.x()) begin_account(stage);
  }
  void begin_account(Stage& stage) const {
    stage.state.memory = {{"direction", setup_.direction.x()},
                          {kShearImpulse, stage.state.memory[kShearImpulse]}};
    take_unrecorded_time(stage);
    stage.state.memory["start"] = piston_of(stage.world).point.x();
    begin_way(stage, 0);
  }
  // With the weight of the piston. [F_g]
  static double normal_load(const World& world) {
    const Wall& piston = piston_of(world);
    return piston.force + (world.gravity ? piston.mass * world.gravity->dot(piston.normal) : 0);
  }
  // Shear rate at full speed times sqrt(m/P), P the normal stress [da Cruz 2005]. [1]
  std::optional<double> inertial_number(const World& world) const {
    const double height = piston_of(world).point.y() - packing_bottom(world);
    const std::optional<double> width = room_width(world);
    const double load = normal_load(world);
    if (!width || height <= 0 || load <= 0) return std::nullopt;
    return *setup_.rate / height * std::sqrt(*width / load);
  }
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
