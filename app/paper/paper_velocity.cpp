// How fast the intruder ploughs: v^2 = k (F - F_0), the law of the companion paper. [arXiv:1012.2696]
#include <cmath>

#include "app/json/json_reader.h"
#include "app/paper/paper_experiments.h"
#include "app/paper/push_speed.h"
#include "app/scene/si_scale.h"
#include "core/linear_fit.h"

namespace quicksand {

namespace {

class Velocity : public PaperExperiment {
 public:
  void plan(PaperJobs& jobs) override {
    all_ = jobs.scale().realizations;
    height_ = jobs.scale().height;
    curve_ = jobs.push_curve(jobs.samples());
    push_ = jobs.jobs()[curve_.pushes.front().runs.front()].scenario;
  }

  void report(const PaperResults& results, const std::filesystem::path&, Section& section,
              Findings& findings) const override {
    const Curve curve = ploughing_speeds(results, "mean velocity", curve_, height_);
    std::vector<double> squares;
    for (const double speed : curve.y) squares.push_back(speed * speed);
    Table table{
        .caption = "Mean velocity of the intruder between 15 % and 60 % of the box's height.",
        .columns = {{"push force [F_c]", true}, {"velocity [√(gd)]", true}}};
    for (std::size_t k = 0; k < curve_.forces.size(); ++k)
      table.rows.push_back({{.text = number_text(curve_.forces[k])},
                            cell_of(ploughing_speed(results, curve_.pushes[k], height_), all_)});
    section.blocks.emplace_back(std::move(table));
    Plot plot{.name = "velocity",
              .title = "Velocity of the driven intruder",
              .x = {.label = "push force", .unit = "F_c"},
              .y = {.label = "mean velocity", .unit = "√(g d)", .low = 0},
              .legend = LegendPlace::bottom_right};
    const auto line = fit_line(curve.x, squares);
    plot.curves.push_back(curve);
    if (line && line->slope > 0 && line->intercept < 0) {
      const double threshold = -line->intercept / line->slope;
      plot.curves.push_back(law(line->slope, threshold, curve.x.back()));
      findings["penetration.threshold_force"] = {
          .value = threshold,
          .n = static_cast<int>(curve.x.size()),
          .note = "where the straight line of v^2 against the force is zero; n counts forces"};
      findings["field.crust_pressure"] =
          crust_pressure(threshold, static_cast<int>(curve.x.size()));
      note_exponent(findings, curve, threshold);
    }
    const bool found = findings.contains("penetration.threshold_force");
    section.blocks.emplace_back(Figure{
        std::move(plot),
        found
            ? "The line is v² = k (F − F_0), fitted to the squares of the velocities."
            : "A straight line through the squares of the velocities gives no threshold: it is not "
              "zero at any positive force."});
  }

 private:
  // The threshold as a pressure on what the intruder covers, its diameter times one of a grain, in SI.
  Measured crust_pressure(double threshold, int forces) const {
    const SiScale si = si_scale(*push_.physical);
    const double force = threshold * *push_.grain_law.cohesion_force * si.force;
    const double area = std::get<PushPhase>(push_.phases[0].kind).diameter * si.length * si.length;
    constexpr double kKilopascal = 1e-3;
    return {.value = force / area * kKilopascal,
            .n = forces,
            .note =
                "the force at which v^2 is zero over the intruder's diameter times a grain's; "
                "n counts forces"};
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
  Scenario push_;
  double height_ = 0;
  int all_ = 0;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_velocity_experiment() { return std::make_unique<Velocity>(); }

}  // namespace quicksand
