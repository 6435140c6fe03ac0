// The phase "penetrate": an intruder of any shape is driven into the packing.
#include <algorithm>

#include "core/drives/drive.h"
#include "core/phases/running_phase.h"
#include "core/placing/placing.h"
#include "core/world/extent.h"
#include "core/world/reaction.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

// The intruder is the last disk as long as its phase lasts.
class Penetrate final : public RunningPhaseOf<PenetratePhase> {
 public:
  using RunningPhaseOf::RunningPhaseOf;

  SearchKind searches_for() const override {
    return settings().threshold ? SearchKind::penetrate : SearchKind::none;
  }

  void begin(Stage& stage) override {
    require_no_intruder(stage);
    World& world = stage.world;
    stage.form_bonds(settings().bonding, settings().bonds);
    world.bonds.mark_initial();
    stage.state.memory["surface"] = packing_top(world);
    const std::vector<ConvexPart> parts = parts_of(settings().shape);
    const double x = settings().x.value_or(world.box.width / 2);
    const Vec2 place = place_on_surface(world, x, parts);
    const Disk placed{.position = place,
                      .radius = parts.front().radius,
                      .density = settings().density,
                      .role = Role::intruder};
    // A disk alone needs no parts.
    if (std::holds_alternative<DiskIntruder>(settings().shape))
      world.disks.add(placed);
    else
      add_shape(world, placed, parts);
    begin_way(stage, depth(stage));
    if (settings().threshold)
      begin_search_on(stage, SearchKind::penetrate, body(stage), settings().force);
  }

  void before_step(Stage& stage) override {
    if (settings().threshold) return begin_force_trial(stage, {0, -1, 0});
    const double share = ramp(stage, settings().ramp_time);
    if (settings().speed)
      return prescribe(stage.world, body(stage), {0, -share * *settings().speed, 0});
    set_free(stage.world, body(stage));  // a session may have driven it at a speed so far
    stage.world.disks.applied[body(stage)] = {0, -share * settings().force, 0};
  }

  bool finished(Stage& stage) override {
    if (settings().threshold)
      return search_is_over(stage, drive_trials(settings()), depth(stage) >= settings().depth,
                            RestOf::driven);
    if (const double time = take_unrecorded_time(stage); time > 0)
      record_load(stage, reaction_on(stage.world, body(stage)).force.y(), time, depth(stage),
                  settings().depth, kDepthWindow);
    if (depth(stage) >= settings().depth || stage.lasted(settings().max_time)) return true;
    if (settings().speed || !stage.lasted(settings().ramp_time)) return false;
    return stage.rests_of(RestOf::driven, body(stage), settings().rest_speed, settings().rest_time);
  }

  void end(Stage& stage) override {
    if (settings().threshold) return;
    const int intruder = body(stage);
    stage.state.drive_results.push_back(
        drive_result(stage, Drive::penetrate, depth(stage), intruder));
    if (settings().speed) prescribe(stage.world, intruder, {0, 0, 0});
    if (!settings().release) return;
    stage.world.disks.applied[intruder] = {0, 0, 0};
    set_free(stage.world, intruder);
  }

  double progress(const Stage& stage) const override {
    if (settings().threshold) return search_progress(stage, drive_trials(settings()));
    const double by_depth = settings().depth > 0 ? depth(stage) / settings().depth : 1;
    return std::max(by_depth, stage.since_start() / settings().max_time);
  }

  bool missed_rest(const Stage& stage) const override {
    if (settings().speed || settings().threshold) return false;
    return stage.state.drive_results.back().way < settings().depth &&
           RunningPhaseOf::missed_rest(stage);
  }

 private:
  static int body(const Stage& stage) { return stage.world.disks.size() - 1; }
  // Of the lowest point below the surface as it was. [d]
  static double depth(const Stage& stage) {
    return stage.state.memory.at("surface") - lowest_point(stage.world, body(stage));
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const PenetratePhase& settings) {
  return std::make_unique<Penetrate>(settings);
}

}  // namespace quicksand
