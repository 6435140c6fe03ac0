// Pushes of a denser specimen, and in water.
#include <cmath>

#include "app/experiments/experiments.h"
#include "app/json/json_reader.h"
#include "app/paper/outcome_table.h"
#include "app/paper/push_speed.h"

namespace quicksand {

namespace {

constexpr double kForce = 1;  // at which drag is compared [F_c]

// Force at which a curve first reaches a value, between its points linear in the logarithm of the force.
std::optional<double> force_for(const Curve& curve, double value) {
  for (std::size_t k = 1; k < curve.x.size(); ++k) {
    const double low = curve.y[k - 1], high = curve.y[k];
    if (low > value || high < value || low == high) continue;
    return curve.x[k - 1] * std::pow(curve.x[k] / curve.x[k - 1], (value - low) / (high - low));
  }
  return std::nullopt;
}

// By how much a force must be larger for `denser` to reach what `usual` reaches: the ratio of forces in the
// middle of the values that both curves have; absent if there are none.
std::optional<double> force_ratio(const Curve& usual, const Curve& denser) {
  if (usual.y.empty() || denser.y.empty()) return std::nullopt;
  const auto [least, most] = std::ranges::minmax(usual.y);
  const auto [denser_least, denser_most] = std::ranges::minmax(denser.y);
  const double middle = (std::max(least, denser_least) + std::min(most, denser_most)) / 2;
  const auto of_usual = force_for(usual, middle), of_denser = force_for(denser, middle);
  if (!of_usual || !of_denser) return std::nullopt;
  return *of_denser / *of_usual;
}

class Density : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    height_ = jobs.scale().height;
    by_interval_ = jobs.scale().denser_if_quicker;
    // A lower rolling friction stays during the push.
    by_drop_ = jobs.scale().nscd.has_value();
    samples_ = {jobs.samples(),
                by_drop_ ? jobs.samples(kHardDrop, {}, hard_drop(*jobs.scale().nscd))
                : by_interval_
                    ? jobs.samples(kDenseDeposition, {}, dense_deposition())
                    : jobs.samples("rolling_0.02", {{"contact.rolling_friction", 0.02}})};
    curves_ = {jobs.push_curve(samples_[0]), jobs.push_curve_below_strongest(samples_[1])};
  }

  void report(const PaperResults& results, Section& section, Findings& findings) const override {
    section.add(Paragraph{
        by_drop_ ? "For the denser specimen the grains' drop velocity is higher by 5 √(gd). All "
                   "contact laws are the same."
        : by_interval_
            ? "For the denser specimen a grain is deposited every 0.001 instead of every 0.01: it "
              "sags while it is being made. All contact laws are the same."
            : "The denser specimen is made with a fifth of the rolling friction, which also "
              "applies while the intruder is pushed; part of the difference may be due to this."});
    const char* const names[] = {"usual specimen", "denser specimen"};
    Plot plot{.name = "density",
              .x = {.label = "push force", .unit = "F_c", .logarithmic = true},
              .y = {.label = "depth", .unit = "d", .low = 0},
              .legend = LegendPlace::bottom_right};
    std::vector<OutcomeRow> rows;
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      const auto density = results.mean(samples_[s], "volume_fraction");
      const std::string name =
          std::string(names[s]) + ", volume fraction " + cell_of(density, all_).text;
      plot.curves.push_back(
          curve_over(results, name, curves_[s].forces, curves_[s].pushes, "depth"));
      for (std::size_t k = 0; k < curves_[s].forces.size(); ++k)
        rows.push_back(
            {name + ", " + number_text(curves_[s].forces[k]) + " F_c", curves_[s].pushes[k]});
    }
    if (!is_denser(results))
      section.add(Remark{Remark::Kind::warning,
                         "Seed by seed, the volume fractions do not differ by more than both 2.5 % "
                         "and two standard errors: the effect of the density is not measured."});
    else
      note(findings, "penetration.density_shift", shift(results));
    section.add(outcome_table(results, "Pushes in both specimens, once everything is at rest.",
                              {"case"}, rows, kAfterPush, all_));
    section.add(Figure{std::move(plot),
                       "Final depth as a function of the push force: means with bars of one "
                       "standard error. The depth jumps where the packing no longer holds."});
  }

 private:
  // Seed by seed, as both are made from the same random numbers: seeds scatter by more than a deposition changes.
  bool is_denser(const PaperResults& results) const {
    constexpr double kLeast = 0.025;  // relative
    const auto change = results.change(samples_[0], samples_[1], "volume_fraction");
    return change && change->value > std::max(kLeast, 2 * change->standard_error.value_or(0));
  }

  // Seed by seed: by the depth, or, where no depth above the floor is reached in both, by the velocity.
  std::optional<Measured> shift(const PaperResults& results) const {
    std::vector<double> by_depth, by_speed;
    for (std::size_t seed = 0; seed < samples_[0].runs.size(); ++seed) {
      if (const auto ratio = force_ratio(depths(results, 0, seed), depths(results, 1, seed)))
        by_depth.push_back(*ratio);
      if (const auto ratio = force_ratio(speeds(results, 0, seed), speeds(results, 1, seed)))
        by_speed.push_back(*ratio);
    }
    if (!by_depth.empty()) return mean_over(by_depth, "compared at the same depth");
    return mean_over(by_speed,
                     "compared at the same mean velocity, as no depth above the floor is reached "
                     "in both specimens");
  }

  // Only those of intruders that the packing stopped.
  Curve depths(const PaperResults& results, std::size_t sample, std::size_t seed) const {
    constexpr double kGround = 0.95;  // share of the packing's height
    const RunResults* specimen = results.run(samples_[sample].runs[seed]);
    Curve stopped;
    for (std::size_t k = 0; specimen && k < curves_[sample].forces.size(); ++k) {
      const RunResults* push = results.run(curves_[sample].pushes[k].runs[seed]);
      const double depth = push ? push->final_value("depth").value_or(HUGE_VAL) : HUGE_VAL;
      if (depth > kGround * specimen->final_value("packing_top").value_or(0)) continue;
      stopped.x.push_back(curves_[sample].forces[k]);
      stopped.y.push_back(depth);
    }
    return stopped;
  }

  Curve speeds(const PaperResults& results, std::size_t sample, std::size_t seed) const {
    Curve speeds;
    for (std::size_t k = 0; k < curves_[sample].forces.size(); ++k) {
      const RunResults* push = results.run(curves_[sample].pushes[k].runs[seed]);
      const auto speed = push ? ploughing_speed(*push, height_) : std::nullopt;
      if (!speed) continue;
      speeds.x.push_back(curves_[sample].forces[k]);
      speeds.y.push_back(*speed);
    }
    return speeds;
  }

  std::vector<RunGroup> samples_;
  std::vector<PushCurve> curves_;  // of each
  bool by_interval_ = true, by_drop_ = false;
  double height_ = 0;
};

class WaterDrag : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    const RunGroup samples = jobs.samples();
    constexpr double kWater = 1e-3;  // viscosity [Pa s]
    // Debris sinks at 1.1 sqrt(g d) by Stokes' law, through all of the height at most: until it rests takes longer than
    // other pushes are given.
    constexpr double kSinking = 1.5;  // [sqrt(d/g) for each d]
    without_ = jobs.pushes(samples, kForce);
    with_ = jobs.pushes(samples, kForce, "drag",
                        {{"drag", {{"viscosity", kWater}}},
                         {"phases[0].max_time", kSinking * jobs.scale().height}});
  }

  void report(const PaperResults& results, Section& section, Findings& findings) const override {
    section.add(outcome_table(results,
                              "Pushes with the cohesion force, with and without the viscous drag "
                              "of water (Stokes' law for each grain).",
                              {"case"}, {{"without drag", without_}, {"with drag", with_}},
                              kAfterPush, all_));
    note(findings, "penetration.drag_effect", largest_change(results));
  }

 private:
  // On the floor the depth says nothing; bonds do.
  std::optional<Measured> largest_change(const PaperResults& results) const {
    std::optional<Measured> largest;
    for (const auto& [quantity, name] :
         {std::pair{"depth", "the depth"}, std::pair{"active_bond_fraction", "active bonds"},
          std::pair{"remaining_bond_fraction", "remaining bonds"}}) {
      auto change = results.change(without_, with_, quantity);
      if (!change) continue;
      change->note = "largest for " + std::string(name);
      if (!largest || std::abs(change->value) > std::abs(largest->value)) largest = change;
    }
    return largest;
  }

  RunGroup without_, with_;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_density_experiment() { return std::make_unique<Density>(); }
std::unique_ptr<PaperExperiment> make_drag_experiment() { return std::make_unique<WaterDrag>(); }

}  // namespace quicksand
