// How fast the intruder ploughs: v^2 = k (F - F_0), the law of the companion paper. [arXiv:1012.2696]
#include <cmath>

#include "app/json/json_reader.h"
#include "app/paper/paper_experiments.h"
#include "core/linear_fit.h"

namespace quicksand {

namespace {

// The part of the box's height over which the mean velocity is taken: past the start, before the ground.
constexpr double kFrom = 0.15, kTo = 0.6;

class Velocity : public PaperExperiment {
 public:
  void plan(PaperJobs& jobs) override {
    all_ = jobs.scale().realizations;
    height_ = jobs.scale().height;
    curve_ = jobs.push_curve(jobs.samples());
  }

  void report(const PaperResults& results, const std::filesystem::path&, Section& section,
              Findings& findings) const override {
    Curve curve{.name = "mean velocity"};
    std::vector<double> squares;
    Table table{
        .caption = "Mean velocity of the intruder between 15 % and 60 % of the box's height.",
        .columns = {{"push force [F_c]", true}, {"velocity [√(gd)]", true}}};
    for (std::size_t k = 0; k < curve_.forces.size(); ++k) {
      std::vector<double> speeds;
      for (const RunResults* run : results.runs(curve_.pushes[k]))
        if (const auto speed = mean_speed(*run)) speeds.push_back(*speed);
      const auto mean = mean_over(speeds);
      table.rows.push_back({{.text = number_text(curve_.forces[k])}, cell_of(mean, all_)});
      if (!mean) continue;
      curve.x.push_back(curve_.forces[k]);
      curve.y.push_back(mean->value);
      curve.y_error.push_back(mean->standard_error.value_or(0));
      squares.push_back(mean->value * mean->value);
    }
    section.blocks.emplace_back(std::move(table));
    Plot plot{.name = "velocity",
              .title = "Velocity of the driven intruder",
              .x = {.label = "push force", .unit = "F_c"},
              .y = {.label = "mean velocity", .unit = "√(g d)", .low = 0},
              .legend = LegendPlace::bottom_right};
    const auto line = fit_line(curve.x, squares);
    plot.curves.push_back(curve);
    if (line && line->slope > 0) {
      const double threshold = -line->intercept / line->slope;
      plot.curves.push_back(law(line->slope, threshold, curve.x.back()));
      findings["penetration.threshold_force"] = {
          .value = threshold,
          .n = static_cast<int>(curve.x.size()),
          .note = "where the straight line of v^2 against the force is zero; n counts forces"};
      note_exponent(findings, curve, threshold);
    }
    section.blocks.emplace_back(Figure{
        std::move(plot), "The line is v² = k (F − F_0), fitted to the squares of the velocities."});
  }

 private:
  // Absent if the intruder did not come that deep.
  std::optional<double> mean_speed(const RunResults& run) const {
    const std::vector<double>&times = run.column("time"), &depths = run.column("depth");
    std::optional<std::size_t> first, last;
    for (std::size_t k = 0; k < times.size(); ++k) {
      if (!first && depths[k] >= kFrom * height_) first = k;
      if (!last && depths[k] >= kTo * height_) last = k;
    }
    if (!first || !last || times[*last] <= times[*first]) return std::nullopt;
    return (depths[*last] - depths[*first]) / (times[*last] - times[*first]);
  }

  static Curve law(double slope, double threshold, double largest) {
    constexpr int kPoints = 60;
    Curve curve{.name = "v² = k (F − F_0)", .kind = Curve::Kind::line, .role = Curve::Role::fit};
    const double start = std::max(0.0, threshold);
    for (int k = 0; k <= kPoints; ++k) {
      const double share = static_cast<double>(k) / kPoints;
      // Closer where the law is steep.
      curve.x.push_back(start + (largest - start) * share * share);
      curve.y.push_back(std::sqrt(slope * (curve.x.back() - threshold)));
    }
    return curve;
  }

  static void note_exponent(Findings& findings, const Curve& curve, double threshold) {
    std::vector<double> x, y;
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      if (curve.x[k] <= threshold) continue;
      x.push_back(std::log(curve.x[k] - threshold));
      y.push_back(std::log(curve.y[k]));
    }
    const auto fit = fit_line(x, y);
    if (!fit || x.size() < 3) return;
    findings["drag_law.exponent"] = {
        .value = fit->slope,
        .standard_error = fit->slope_error,
        .n = static_cast<int>(x.size()),
        .note = "with the threshold of the fit of v^2, which favours 1/2; n counts forces"};
  }

  PushCurve curve_;
  double height_ = 0;
  int all_ = 0;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_velocity_experiment() { return std::make_unique<Velocity>(); }

}  // namespace quicksand
