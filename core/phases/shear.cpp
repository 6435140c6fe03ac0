// The phase "shear": the smallest horizontal force that moves a grain, at several depths.
#include <cmath>
#include <utility>

#include "core/measures/critical_force.h"
#include "core/protocol/running_phase.h"
#include "core/world/extent.h"

namespace quicksand {

namespace {

// A grain is at a depth if its centre is at most this far above or below it. [d]
constexpr double kDepthBand = 0.5;

// Indices of the movable grains at this height, ascending.
std::vector<int> grains_at(const World& world, double height) {
  std::vector<int> grains;
  const Disks& disks = world.disks;
  for (int i = 0; i < disks.size(); ++i)
    if (disks.role[i] == DiskRole::grain && !disks.fixed(i) &&
        std::abs(disks.position[i].y() - height) <= kDepthBand)
      grains.push_back(i);
  return grains;
}

// Draws up to `most` of the items, without repetition.
void draw(std::vector<int>& items, std::size_t most, Random& random) {
  for (std::size_t k = 0; k < std::min(most, items.size()); ++k) {
    const auto left = static_cast<double>(items.size() - k);
    std::swap(items[k], items[k + static_cast<std::size_t>(random.uniform() * left)]);
  }
  if (items.size() > most) items.resize(most);
}

class Shear final : public RunningPhaseOf<ShearPhase> {
 public:
  using RunningPhaseOf::RunningPhaseOf;

  SearchKind searches_for() const override { return SearchKind::shear; }

  void begin(Stage& stage) override {
    World& world = stage.world;
    stage.form_bonds(false);
    std::vector<SearchTarget> targets;
    const double top = packing_top(world);
    for (const double depth : settings().depths) {
      std::vector<int> grains = grains_at(world, top - depth);
      draw(grains, static_cast<std::size_t>(settings().grains_per_depth), world.random);
      for (const int grain : grains)
        targets.push_back(
            {.body = grain, .depth = depth, .weight_above = weight_above(world, top - depth)});
    }
    begin_search(stage, SearchKind::shear);
    stage.state.search.targets = std::move(targets);
    stage.state.search.bracket.first = settings().trials.first_force;
  }

  void before_step(Stage& stage) override { begin_force_trial(stage, {1, 0, 0}); }

  bool finished(Stage& stage) override {
    const Search& search = stage.state.search;
    const SearchTrials& trials = settings().trials;
    if (!search.trial_runs) return search_is_over(stage, trials, false);
    // Positions are not wrapped at periodic sides.
    const int grain = search.targets.front().body;
    const double moved =
        stage.world.disks.position[grain].x() - search.base->disks.position[grain].x();
    return search_is_over(stage, trials, moved >= settings().distance, trials.until);
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const ShearPhase& settings) {
  return std::make_unique<Shear>(settings);
}

}  // namespace quicksand
