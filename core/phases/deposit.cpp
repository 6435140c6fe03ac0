// The phase "deposit": grains fall one by one and stick where they touch. Adiabatic: whole specimens, each slower than
// the last, until the volume fraction no longer changes; each begins with the same random numbers, so that two of them
// differ by the interval alone.
#include <algorithm>
#include <cmath>

#include "core/measures/measures.h"
#include "core/protocol/running_phase.h"
#include "core/scene/grain_sizes.h"
#include "core/world/ballistic.h"
#include "core/world/extent.h"

namespace quicksand {

namespace {

// The interval after this one; empty if that would be too long.
std::optional<double> longer(const Adiabatic& adiabatic, double interval) {
  constexpr double kRounding = 1e-9;
  const double next = interval * adiabatic.factor;
  return next <= adiabatic.max_interval * (1 + kRounding) ? std::optional(next) : std::nullopt;
}

class Deposit final : public RunningPhaseOf<DepositPhase> {
 public:
  using RunningPhaseOf::RunningPhaseOf;

  SearchKind searches_for() const override {
    return settings().adiabatic ? SearchKind::adiabatic : SearchKind::none;
  }

  void begin(Stage& stage) override {
    stage.form_bonds(true, settings().bonds);
    if (settings().adiabatic) {
      begin_search(stage, SearchKind::adiabatic);
      stage.state.search.interval = settings().interval;
    }
    begin_specimen(stage);
  }

  void before_step(Stage& stage) override {
    if (settings().adiabatic && !stage.state.search.trial_runs) begin_specimen(stage);
    const double limit = static_cast<double>(settings().grains);
    const auto drops = [&] {
      return full(stage) == 0 && (limit == 0 || dropped(stage) < limit) &&
             stage.due(next_drop(stage), interval(stage));
    };
    if (!drops()) return;
    LandingSite site(stage.world);
    std::vector<Pair> bonded;
    for (; drops(); next_drop(stage) += interval(stage))
      full(stage) = drop_grain(stage, site, bonded) ? 0 : 1;
    std::ranges::sort(bonded);
    stage.world.bonds.form(bonded);
  }

  void settings_changed(Stage& stage, const Phase&) override {
    stage.form_bonds(true, settings().bonds);
  }

  bool finished(Stage& stage) override {
    const double limit = static_cast<double>(settings().grains);
    const bool all = full(stage) != 0 || (limit > 0 && dropped(stage) >= limit);
    if (!all || !stage.due(next_drop(stage), interval(stage))) return false;
    return !settings().adiabatic || is_adiabatic(stage);
  }

  double progress(const Stage& stage) const override {
    const auto grains = stage.state.memory.find("dropped");
    const double of_specimen = settings().grains == 0 ? packing_top(stage.world) / settings().height
                               : grains == stage.state.memory.end()
                                   ? 0
                                   : grains->second / static_cast<double>(settings().grains);
    return settings().adiabatic ? adiabatic_progress(stage, std::min(1.0, of_specimen))
                                : of_specimen;
  }

 private:
  static double& next_drop(Stage& stage) { return stage.state.memory["next_drop"]; }  // time
  static double& dropped(Stage& stage) { return stage.state.memory["dropped"]; }      // grains
  // Whether no place is left below the height: 0 or 1.
  static double& full(Stage& stage) { return stage.state.memory["full"]; }

  double interval(const Stage& stage) const {
    return settings().adiabatic ? stage.state.search.interval : settings().interval;
  }

  void begin_specimen(Stage& stage) {
    if (settings().adiabatic) begin_trial(stage);
    dropped(stage) = full(stage) = 0;
    next_drop(stage) = stage.world.time;
  }

  // Drops one grain at a random place, to which it may bond; false if there is no place left below the
  // height.
  bool drop_grain(Stage& stage, LandingSite& site, std::vector<Pair>& bonded) {
    World& world = stage.world;
    const double height = settings().height;
    double radius = 0.5;
    if (settings().polydispersity) {
      const double before_cut = deviation_before_cut(settings().polydispersity->deviation);
      radius = draw_diameter(world.random, before_cut) / 2;
    }
    const Box& box = world.box;
    const double margin = box.sides == Sides::walls ? radius : 0;
    // A surface is never flat: the packing is full when as many grains in a row as the box is wide
    // found no place.
    const int tries = height > 0 ? std::max(10, static_cast<int>(box.width)) : 1;
    for (int k = 0; k < tries; ++k) {
      const double x = margin + world.random.uniform() * (box.width - 2 * margin);
      const std::optional<Landing> landing = site.land(x, radius, settings().capture_radius);
      if (!landing || (height > 0 && landing->centre.y() + radius > height)) continue;
      const int grain = world.disks.add({.position = landing->centre,
                                         .radius = radius,
                                         .velocity = {0, -settings().drop_velocity}});
      site.add(grain);
      const int touched = landing->touched;
      const Pair pair = is_wall(touched) ? Pair{grain, touched} : Pair{touched, grain};
      if (world.law(pair).cohesion_force) bonded.push_back(pair);
      ++dropped(stage);
      return true;
    }
    return false;
  }

  // The present specimen is complete: records it; true if it was the last.
  bool is_adiabatic(Stage& stage) {
    Search& search = stage.state.search;
    if (!search.trial_runs) return false;
    search.trial_runs = false;
    const Sample sample = measure(stage.world);
    AdiabaticDeposit now{.phase = stage.state.phase,
                         .interval = search.interval,
                         .volume_fraction = sample.volume_fraction.value_or(0),
                         .coordination = sample.coordination,
                         .grains = sample.grains};
    std::vector<AdiabaticDeposit>& deposits = stage.state.adiabatic_deposits;
    if (search.finished > 0) {
      const double before = deposits.back().volume_fraction;
      if (before > 0) now.change = (now.volume_fraction - before) / before;
    }
    deposits.push_back(now);
    ++search.finished;
    const std::optional<double> next = longer(*settings().adiabatic, search.interval);
    if (!next || (now.change && std::abs(*now.change) < settings().adiabatic->tolerance))
      return true;
    search.interval = *next;
    return false;
  }

  // By the time of all specimens, if the longest interval is needed.
  double adiabatic_progress(const Stage& stage, double of_specimen) const {
    const Search& search = stage.state.search;
    double done = search.trial_runs ? of_specimen * search.interval : 0, all = 0;
    for (std::optional<double> interval = settings().interval; interval;
         interval = longer(*settings().adiabatic, *interval)) {
      all += *interval;
      if (*interval < search.interval) done += *interval;
    }
    return done / all;
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const DepositPhase& settings) {
  return std::make_unique<Deposit>(settings);
}

}  // namespace quicksand
