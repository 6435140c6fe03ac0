// Pushes of a denser sample, and in water.
#include <cmath>

#include "app/json/json_reader.h"
#include "app/paper/outcome_table.h"
#include "app/paper/paper_experiments.h"
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
  void plan(PaperJobs& jobs) override {
    all_ = jobs.scale().realizations;
    height_ = jobs.scale().height;
    by_interval_ = jobs.scale().denser_if_quicker;
    // A lower rolling friction stays during the push.
    samples_ = {jobs.samples(),
                by_interval_ ? jobs.samples(kDenseDeposition, {}, dense_deposition())
                             : jobs.samples("rolling_0.02", {{"contact.rolling_friction", 0.02}})};
    for (const RunGroup& sample : samples_) curves_.push_back(jobs.push_curve(sample));
  }

  void report(const PaperResults& results, const std::filesystem::path&, Section& section,
              Findings& findings) const override {
    section.blocks.emplace_back(Paragraph{
        by_interval_ ? "The denser sample is made with a grain every 0.001 in place of 0.01: it "
                       "sinks into itself while it is made. All laws are the same."
                     : "The denser sample is made with a fifth of the rolling friction, which "
                       "also holds while the intruder is pushed: part of the difference may be "
                       "due to that."});
    const char* const names[] = {"usual sample", "denser sample"};
    Plot plot{.name = "density",
              .title = "Depth of the intruder in samples of two densities",
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
    const Curve &usual = plot.curves[0], &denser = plot.curves[1];
    if (const auto ratio = force_ratio(usual, denser)) {
      findings["penetration.density_shift"] = {.value = *ratio, .n = 2, .note = "n counts samples"};
    } else if (const auto by_speed = force_ratio(speeds(results, 0), speeds(results, 1))) {
      findings["penetration.density_shift"] = {
          .value = *by_speed,
          .n = 2,
          .note = "for the same mean velocity, as no depth is reached in both; n counts samples"};
    }
    section.blocks.emplace_back(
        push_outcomes(results, "Pushes of both samples, after everything rests.", rows, all_));
    section.blocks.emplace_back(Figure{std::move(plot), "Final depth against the push force."});
  }

 private:
  Curve speeds(const PaperResults& results, std::size_t sample) const {
    return ploughing_speeds(results, {}, curves_[sample], height_);
  }

  std::vector<RunGroup> samples_;
  std::vector<PushCurve> curves_;  // of each
  bool by_interval_ = true;
  double height_ = 0;
  int all_ = 0;
};

class WaterDrag : public PaperExperiment {
 public:
  void plan(PaperJobs& jobs) override {
    all_ = jobs.scale().realizations;
    const RunGroup samples = jobs.samples();
    constexpr double kWater = 1e-3;  // viscosity [Pa s]
    without_ = jobs.pushes(samples, kForce);
    with_ = jobs.pushes(samples, kForce, "drag", {{"drag", {{"viscosity", kWater}}}});
  }

  void report(const PaperResults& results, const std::filesystem::path&, Section& section,
              Findings& findings) const override {
    section.blocks.emplace_back(
        push_outcomes(results,
                      "Pushes with the cohesion force, with and without viscous drag of water "
                      "(Stokes' law on each grain).",
                      {{"without drag", without_}, {"with drag", with_}}, all_));
    std::vector<double> changes;
    constexpr double kGround = 0.95;  // share of the packing's height
    bool on_the_ground = true;
    for (std::size_t k = 0; k < with_.runs.size(); ++k) {
      const RunResults *with = results.run(with_.runs[k]), *without = results.run(without_.runs[k]);
      if (!with || !without) continue;
      const double depth = *without->final_value("depth");
      changes.push_back((*with->final_value("depth") - depth) / depth);
      on_the_ground = on_the_ground && depth > kGround * without->column("packing_top").front();
    }
    note(findings, "penetration.drag_effect",
         mean_over(changes, on_the_ground
                                ? "without drag all lie on the ground: see the shares of bonds"
                                : ""));
  }

 private:
  RunGroup without_, with_;
  int all_ = 0;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_density_experiment() { return std::make_unique<Density>(); }
std::unique_ptr<PaperExperiment> make_drag_experiment() { return std::make_unique<WaterDrag>(); }

}  // namespace quicksand
