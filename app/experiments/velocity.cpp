// How fast the intruder ploughs: v^2 = k (F - F_0), the law of the companion paper. [arXiv:1012.2696]
#include <cmath>

#include "app/experiments/experiments.h"
#include "app/json/json_reader.h"
#include "app/paper/push_speed.h"
#include "app/scene_json/si_scale.h"
#include "core/measures/linear_fit.h"
#include "core/scene/scenario.h"

namespace quicksand {

namespace {

class Velocity : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    height_ = jobs.scale().height;
    const RunGroup samples = jobs.samples();
    curve_ = jobs.push_curve(samples);
    thresholds_ = jobs.thresholds(samples, kPloughsFrom * height_);
    push_ = jobs.jobs()[curve_.pushes.front().runs.front()].scenario;
  }

  void report(const PaperResults& results, Section& section, Findings& findings) const override {
    const Curve curve = ploughing_speeds(results, "mean velocity", curve_, height_);
    std::vector<double> squares;
    for (const double speed : curve.y) squares.push_back(speed * speed);
    Table table{
        .caption = "Mean velocity of the intruder between 15 % and 60 % of the box's height.",
        .columns = {{"push force [F_c]", true}, {"velocity [√(gd)]", true}}};
    for (std::size_t k = 0; k < curve_.forces.size(); ++k)
      table.rows.push_back({{.text = number_text(curve_.forces[k])},
                            cell_of(ploughing_speed(results, curve_.pushes[k], height_), all_)});
    section.add(std::move(table));
    Plot plot{.name = "velocity",
              .x = {.label = "push force", .unit = "F_c"},
              .y = {.label = "mean velocity", .unit = "√(g d)", .low = 0},
              .legend = LegendPlace::bottom_right};
    const auto line = fit_line(curve.x, squares);
    plot.curves.push_back(curve);
    std::optional<double> of_line;
    if (line && line->slope > 0 && line->intercept < 0) {
      of_line = -line->intercept / line->slope;
      plot.curves.push_back(law(line->slope, *of_line, curve.x.back()));
    }
    report_threshold(results, section, findings);
    if (const auto found = findings.find("penetration.threshold_force"); found != findings.end())
      plot.references.push_back({.name = "smallest force that enters",
                                 .low = found->second.value,
                                 .of_x = true,
                                 .role = Reference::Role::guide});
    section.add(Figure{
        std::move(plot),
        of_line ? "Means with bars of one standard error. The dashed line is v² = k (F − F_0), "
                  "fitted to "
                  "the squares of the velocities; its F_0 is " +
                      cell_of(Measured{.value = *of_line}, 1).text + " F_c."
                : std::string("A straight line through the squares of the velocities gives no "
                              "threshold: it is not zero at any positive force.")});
    note_exponent(findings, curve);
  }

 private:
  // The smallest force with which the intruder enters, also as a pressure on what it covers, its diameter times one of a
  // grain, in SI.
  void report_threshold(const PaperResults& results, Section& section, Findings& findings) const {
    const double cohesion = *push_.grain_law.cohesion_force;
    const SiScale si = si_scale(*push_.physical);
    const double area = std::get<PushPhase>(push_.phases[0].kind).diameter * si.length * si.length;
    const auto force = results.critical_force(
        thresholds_, cohesion,
        "searched for: what takes the intruder down to 15 % of the box's height");
    if (!force) return;
    note(findings, "penetration.threshold_force", force);
    note(findings, "field.crust_pressure",
         results.critical_force(thresholds_, area / (si.force * kKilopascals),
                                "that force over the intruder's diameter times a grain's"));
    section.add(
        Paragraph{"Each specimen was searched for the smallest force with which the intruder sinks "
                  "by 15 % of the box's height, from where it lies on the surface: " +
                  cell_of(force, all_).text + " F_c."});
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

  // Of v against F - threshold [F_c], on logarithmic axes; of the forces above it.
  static std::optional<Line> power_law(const Curve& curve, double threshold) {
    std::vector<double> x, y;
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      if (curve.x[k] <= threshold || curve.y[k] <= 0) continue;
      x.push_back(std::log(curve.x[k] - threshold));
      y.push_back(std::log(curve.y[k]));
    }
    return x.size() < 3 ? std::nullopt : fit_line(x, y);
  }

  // With the force that was searched for, so that it does not depend on the law. Its error is that of the line or, if
  // larger, what the errors of the velocities make of it, and what that of the threshold does, both by repeating the
  // fit with one value a standard error off.
  static void note_exponent(Findings& findings, const Curve& curve) {
    const auto found = findings.find("penetration.threshold_force");
    if (found == findings.end()) return;
    const Measured& threshold = found->second;
    const auto fit = power_law(curve, threshold.value);
    if (!fit) return;
    const auto change = [&](const Curve& other, double at) {
      const auto moved = power_law(other, at);
      return moved ? moved->slope - fit->slope : 0;
    };
    double by_velocities = 0;
    for (std::size_t k = 0; k < curve.y_error.size(); ++k) {
      Curve other = curve;
      other.y[k] += curve.y_error[k];
      by_velocities = std::hypot(by_velocities, change(other, threshold.value));
    }
    const double off = threshold.standard_error.value_or(0);
    const double by_threshold = std::max(std::abs(change(curve, threshold.value - off)),
                                         std::abs(change(curve, threshold.value + off)));
    findings["drag_law.exponent"] = {
        .value = fit->slope,
        .standard_error =
            std::hypot(std::max(fit->slope_error.value_or(0), by_velocities), by_threshold),
        .n = static_cast<int>(
            std::ranges::count_if(curve.x, [&](double force) { return force > threshold.value; })),
        .note = "with the threshold that was searched for, of the forces above it"};
  }

  PushCurve curve_;
  RunGroup thresholds_;
  Scenario push_;
  double height_ = 0;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_velocity_experiment() { return std::make_unique<Velocity>(); }

}  // namespace quicksand
