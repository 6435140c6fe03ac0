// The phase "shear": the smallest horizontal force that moves a grain, at several depths.
#include <cmath>
#include <utility>

#include "core/measures/critical_force.h"
#include "core/measures/measures.h"
#include "core/phases/protocol.h"
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
    if (disks.role[i] == Role::grain && !disks.fixed(i) &&
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

}  // namespace

void Protocol::enter(const ShearPhase& phase) {
  form_bonds(false);
  std::vector<SearchTarget> targets;
  const double top = packing_top(world_);
  for (const double depth : phase.depths) {
    std::vector<int> grains = grains_at(world_, top - depth);
    draw(grains, static_cast<std::size_t>(phase.grains_per_depth), world_.random);
    for (const int grain : grains)
      targets.push_back(
          {.body = grain, .depth = depth, .weight_above = weight_above(world_, top - depth)});
  }
  begin_search(SearchKind::shear);
  state_.search.targets = std::move(targets);
  state_.search.bracket.first = phase.trials.first_force;
}

void Protocol::before_step(const ShearPhase&) { begin_force_trial({1, 0}); }

bool Protocol::is_over(const ShearPhase& phase) {
  const Search& search = state_.search;
  if (!search.trial_runs) return search_is_over(phase.trials, false);
  // Positions are not wrapped at periodic sides.
  const int grain = search.targets.front().body;
  const double moved = world_.disks.position[grain].x() - search.base->disks.position[grain].x();
  return search_is_over(phase.trials, moved >= phase.distance, phase.trials.until);
}

double Protocol::progress(const ShearPhase& phase) const { return search_progress(phase.trials); }

}  // namespace quicksand
