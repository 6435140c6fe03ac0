// The phase "push": an intruder is pushed into the packing, or the smallest force is sought with which it enters.
#include "core/protocol/running_phase.h"
#include "core/world/ballistic.h"

namespace quicksand {

SearchTrials threshold_trials(const PushPhase& push) {
  return {.first_force = push.force,
          .tolerance = push.threshold.value_or(Threshold{}).tolerance,
          .rest_speed = push.rest_speed,
          .rest_time = push.rest_time,
          .max_time = push.max_time};
}

namespace {

// The intruder is the last disk as long as its phase lasts.
class Push final : public RunningPhaseOf<PushPhase> {
 public:
  using RunningPhaseOf::RunningPhaseOf;

  SearchKind searches_for() const override {
    return settings().threshold ? SearchKind::push : SearchKind::none;
  }

  void begin(Stage& stage) override {
    World& world = stage.world;
    stage.form_bonds(settings().bonding, settings().bonds);
    world.bonds.mark_initial();
    const double radius = settings().diameter / 2;
    const double x = settings().x.value_or(world.box.width / 2);
    const std::optional<Landing> landing = LandingSite(world).land(x, radius);
    const Vec2 centre = landing ? landing->centre : Vec2(x, radius);
    const int intruder = world.disks.add({.position = centre,
                                          .radius = radius,
                                          .density = settings().density,
                                          .role = DiskRole::intruder});
    if (!settings().threshold) return renew_force(stage);
    begin_search_on(stage, SearchKind::push, intruder, settings().force);
  }

  bool can_go_on(const Stage& stage) const override {
    const auto& role = stage.world.disks.role;
    return !role.empty() && role.back() == DiskRole::intruder;
  }

  void before_step(Stage& stage) override {
    if (settings().threshold) begin_force_trial(stage, {0, -1, 0});
  }

  bool finished(Stage& stage) override {
    const int intruder = stage.world.disks.size() - 1;
    const RestOf until = settings().until;
    if (!settings().threshold) {
      const bool rest =
          stage.rests_of(until, intruder, settings().rest_speed, settings().rest_time);
      return rest || stage.lasted(settings().max_time);
    }
    const Search& search = stage.state.search;
    const double way =
        search.base->disks.position[intruder].y() - stage.world.disks.position[intruder].y();
    const bool entered =
        search.trial_runs && way >= settings().threshold->distance.value_or(settings().diameter);
    return search_is_over(stage, threshold_trials(settings()), entered, until);
  }

  double progress(const Stage& stage) const override {
    return settings().threshold ? search_progress(stage, threshold_trials(settings()))
                                : RunningPhaseOf::progress(stage);
  }

  void end(Stage& stage) override {
    if (settings().release) stage.world.disks.applied.back() = {0, 0, 0};
  }

  void settings_changed(Stage& stage, const Phase& before) override {
    RunningPhaseOf::settings_changed(stage, before);
    const auto* pushed = std::get_if<PushPhase>(&before.kind);
    if (!pushed || pushed->force != settings().force) renew_force(stage);
  }

  // A search sets its force in the next trial.
  void renew_force(Stage& stage) override {
    if (!settings().threshold) stage.world.disks.applied.back() = {0, -settings().force, 0};
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const PushPhase& settings) {
  return std::make_unique<Push>(settings);
}

}  // namespace quicksand
