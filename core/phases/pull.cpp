// The phase "pull": the smallest upward force that takes the intruder out.
#include "core/phases/drive.h"
#include "core/world/extent.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

class Pull final : public RunningPhaseOf<PullPhase> {
 public:
  using RunningPhaseOf::RunningPhaseOf;

  SearchKind searches_for() const override { return SearchKind::pull; }

  void begin(Stage& stage) override {
    stage.form_bonds(false);
    const int intruder = stage.world.intruder();
    if (intruder < 0) return begin_search(stage, SearchKind::pull);
    set_free(stage.world, intruder);  // what held it so far, such as a drive at a rate, lets go
    begin_search_on(stage, SearchKind::pull, intruder, settings().trials.first_force);
  }

  void before_step(Stage& stage) override { begin_force_trial(stage, {0, 1, 0}); }

  bool finished(Stage& stage) override {
    const Search& search = stage.state.search;
    const SearchTrials& trials = settings().trials;
    if (!search.trial_runs) return search_is_over(stage, trials, false);
    const int intruder = search.targets.front().body;
    const double height = stage.world.disks.position[intruder].y();
    constexpr double kClear = 1e-3;  // above the top, so that what lies on it is not yet out [d]
    const bool out =
        settings().distance
            ? height >= search.base->disks.position[intruder].y() + *settings().distance
            : lowest_point(stage.world, intruder) > packing_top(*search.base) + kClear;
    return search_is_over(stage, trials, out, trials.until);
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const PullPhase& settings) {
  return std::make_unique<Pull>(settings);
}

}  // namespace quicksand
