// The phase "vane": a vane, or the intruder that is there, is turned in the packing.
#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/drives/drive.h"
#include "core/phases/running_phase.h"
#include "core/placing/remove_disks.h"
#include "core/world/extent.h"
#include "core/world/reaction.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

class Vane final : public RunningPhaseOf<VanePhase> {
 public:
  using RunningPhaseOf::RunningPhaseOf;

  SearchKind searches_for() const override {
    return settings().threshold ? SearchKind::vane : SearchKind::none;
  }

  void begin(Stage& stage) override {
    World& world = stage.world;
    stage.form_bonds(settings().bonding, settings().bonds);
    if (settings().shape) embed(stage);
    const int intruder = world.intruder();
    const std::string where = "phases[" + std::to_string(stage.state.phase) + "]";
    if (intruder < 0) throw InputError(where, "turns an intruder, and there is none");
    stage.state.memory["start"] = world.disks.angle[intruder];
    begin_way(stage, 0);
    world.disks.applied[intruder].setZero();
    set_free(world, intruder);
    if (settings().threshold) begin_search_on(stage, SearchKind::vane, intruder, settings().torque);
  }

  void before_step(Stage& stage) override {
    if (settings().threshold) return begin_force_trial(stage, {0, 0, 1});
    const int intruder = stage.world.intruder();
    const double share = ramp(stage, settings().ramp_time);
    if (settings().angular_velocity)
      return prescribe(stage.world, intruder, {0, 0, share * *settings().angular_velocity});
    set_free(stage.world, intruder);  // a session may have turned it at a speed so far
    stage.world.disks.applied[intruder] = {0, 0, share * settings().torque};
  }

  bool finished(Stage& stage) override {
    if (settings().threshold)
      return search_is_over(stage, drive_trials(settings()), turned(stage) >= settings().angle,
                            RestOf::driven);
    const World& world = stage.world;
    const int intruder = world.intruder();
    if (const double time = take_unrecorded_time(stage); time > 0)
      record_load(stage, -reaction_on(world, intruder).torque, time, turned(stage),
                  settings().angle, kAngleWindow);
    if (turned(stage) >= settings().angle || stage.lasted(settings().max_time)) return true;
    if (settings().angular_velocity || !stage.lasted(settings().ramp_time)) return false;
    const double reach = reach_of(world, intruder);
    const Vec3& v = world.disks.velocity[intruder];
    return stage.rested(v.head<2>().norm() + reach * std::abs(v.z()) <= settings().rest_speed,
                        settings().rest_time);
  }

  void end(Stage& stage) override {
    if (settings().threshold) return;
    const int intruder = stage.world.intruder();
    stage.state.drive_results.push_back(drive_result(stage, Drive::vane, turned(stage), intruder));
    if (settings().angular_velocity) prescribe(stage.world, intruder, {0, 0, 0});
    if (!settings().release) return;
    stage.world.disks.applied[intruder] = {0, 0, 0};
    set_free(stage.world, intruder);
  }

  double progress(const Stage& stage) const override {
    if (settings().threshold) return search_progress(stage, drive_trials(settings()));
    return std::max(turned(stage) / settings().angle, stage.since_start() / settings().max_time);
  }

  bool missed_rest(const Stage& stage) const override {
    if (settings().angular_velocity || settings().threshold) return false;
    return stage.state.drive_results.back().way < settings().angle &&
           RunningPhaseOf::missed_rest(stage);
  }

 private:
  static double turned(const Stage& stage) {
    return stage.world.disks.angle[stage.world.intruder()] - stage.state.memory.at("start");
  }

  void embed(Stage& stage) const {
    require_no_intruder(stage);
    World& world = stage.world;
    world.bonds.mark_initial();
    const Vec2 axis(settings().x.value_or(world.box.width / 2),
                    packing_top(world) - settings().depth);
    add_shape(world, {.position = axis, .density = settings().density},
              parts_of(*settings().shape));
    constexpr double kOverlap = 1e-9;  // [d]
    std::vector<Pair> pairs;
    add_shaped_pairs(world, -kOverlap, pairs);
    std::vector<char> marked(static_cast<std::size_t>(world.disks.size()), 0);
    const std::string where = "phases[" + std::to_string(stage.state.phase) + "]";
    for (const Pair& pair : pairs) {
      if (is_wall(pair.b))
        throw InputError(where + ".depth", "puts the vane into a wall; give another depth or x");
      marked[static_cast<std::size_t>(pair.a)] = 1;
    }
    const auto in_the_way = std::ranges::count(marked, 1);
    if (in_the_way > 0 && !settings().clear)
      throw InputError(where + ".clear",
                       "is false, and " + std::to_string(in_the_way) +
                           " grains are where the vane is to be; with \"clear\": true they are "
                           "taken away");
    remove_disks(world, marked);
    stage.state.memory["cleared"] = static_cast<double>(in_the_way);
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const VanePhase& settings) {
  return std::make_unique<Vane>(settings);
}

}  // namespace quicksand
