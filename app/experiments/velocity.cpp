// How fast the intruder ploughs: v^2 = k (F - F_0), the law of the companion paper [arXiv:1012.2696], and the power law
// of the force beyond the one that was searched for.
#include <cmath>

#include "app/experiments/experiments.h"
#include "app/json/json_reader.h"
#include "app/paper/push_speed.h"
#include "app/scene_json/si_scale.h"
#include "core/measures/linear_fit.h"
#include "core/scene/scenario.h"

namespace quicksand {

namespace {

constexpr const char* kPowerLaw = "v = c (F − F_e)ᵅ";

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
        .caption =
            "Mean velocity of the intruder between depths of 15 % and 60 % of the box's height.",
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
      plot.curves.push_back(fitted("v² = k (F − F_0)", 0, *of_line, curve.x.back(),
                                   [&](double beyond) { return std::sqrt(line->slope * beyond); }));
    }
    std::string fits =
        of_line ? "A straight line through the squared velocities, v² = k (F − F_0), vanishes at "
                  "F_0 = " +
                      cell_of(Measured{.value = *of_line}, 1).text + " F_c."
                : "A straight line through the squared velocities gives no threshold: it vanishes "
                  "at no positive force.";
    report_threshold(results, section, findings);
    if (const auto found = findings.find("penetration.threshold_force"); found != findings.end()) {
      const Measured& entry = found->second;
      plot.references.push_back({.name = "smallest force of entry F_e",
                                 .low = entry.value,
                                 .of_x = true,
                                 .role = Reference::Role::guide});
      if (const auto law = power_law(curve, entry.value)) {
        const Measured exponent = exponent_with_errors(curve, entry, *law);
        findings["drag_law.exponent"] = exponent;
        plot.curves.push_back(fitted(kPowerLaw, 1, entry.value, curve.x.back(), [&](double beyond) {
          return law->at_one * std::pow(beyond, law->exponent);
        }));
        fits += std::string(" The exponent of ") + kPowerLaw + " is " +
                cell_of(exponent, exponent.n).text + ".";
      }
    }
    section.add(Paragraph{std::move(fits)});
    section.add(Figure{std::move(plot),
                       std::string("Means with bars of one standard error. Dashed: v² = k (F − "
                                   "F_0), fitted to the squared velocities. Dash-dotted: ") +
                           kPowerLaw +
                           ", where F_e is the force found by the search, fitted to the forces "
                           "above it."});
  }

 private:
  // The smallest force with which the intruder enters, also as a pressure on what it covers, its diameter times one of a
  // grain, in SI.
  void report_threshold(const PaperResults& results, Section& section, Findings& findings) const {
    const double cohesion = *push_.grain_law.cohesion_force;
    const SiScale si = si_scale(*push_.physical);
    const double area = std::get<PushPhase>(push_.phases[0].kind).diameter * si.length * si.length;
    const auto force = results.critical_force(thresholds_, cohesion,
                                              "found by a search: the smallest force that takes "
                                              "the intruder down by 15 % of the box's height");
    if (!force) return;
    note(findings, "penetration.threshold_force", force);
    note(findings, "field.crust_pressure",
         results.critical_force(
             thresholds_, area / (si.force * kKilopascals),
             "the threshold force divided by the intruder's diameter times a grain's"));
    section.add(
        Paragraph{"A search in each specimen gives the smallest force with which the intruder, "
                  "initially on the surface, sinks by 15 % of the box's height: " +
                  cell_of(force, all_).text + " F_c."});
  }

  // velocity(force - threshold) from the threshold on, closer there, where it is steep.
  template <class Law>
  static Curve fitted(std::string name, std::size_t style, double threshold, double largest,
                      const Law& velocity) {
    constexpr int kPoints = 60;
    Curve curve{.name = std::move(name),
                .kind = Curve::Kind::line,
                .role = Curve::Role::fit,
                .style = style};
    const double start = std::max(0.0, threshold);
    for (int k = 0; k <= kPoints; ++k) {
      const double share = static_cast<double>(k) / kPoints;
      curve.x.push_back(start + (largest - start) * share * share);
      curve.y.push_back(velocity(curve.x.back() - threshold));
    }
    return curve;
  }

  // Of v against F - threshold [F_c], on logarithmic axes; of the forces above it.
  struct PowerLaw {
    double exponent = 0;
    // By the scatter about the line or, if larger, by the errors of the velocities.
    double error = 0;
    double at_one = 0;  // the velocity where the force is F_c above the threshold [sqrt(g d)]
    int forces = 0;
  };
  static std::optional<PowerLaw> power_law(const Curve& curve, double threshold) {
    std::vector<double> x, y, error;
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      if (curve.x[k] <= threshold || curve.y[k] <= 0) continue;
      x.push_back(std::log(curve.x[k] - threshold));
      y.push_back(std::log(curve.y[k]));
      error.push_back(curve.y_error[k] / curve.y[k]);
    }
    if (x.size() < 3) return std::nullopt;
    const auto line = fit_line(x, y);
    if (!line) return std::nullopt;
    return PowerLaw{.exponent = line->slope,
                    .error = std::max(line->slope_error.value_or(0), slope_error_by(x, error)),
                    .at_one = std::exp(line->intercept),
                    .forces = static_cast<int>(x.size())};
  }

  // With the force that was searched for, so that it does not depend on the law v² = k (F − F_0). What the error of that
  // force makes of the exponent is found with a threshold one standard error lower and one higher.
  static Measured exponent_with_errors(const Curve& curve, const Measured& threshold,
                                       const PowerLaw& law) {
    double by_threshold = 0;
    for (const double off :
         {-threshold.standard_error.value_or(0), threshold.standard_error.value_or(0)})
      if (const auto other = power_law(curve, threshold.value + off))
        by_threshold = std::max(by_threshold, std::abs(other->exponent - law.exponent));
    return {.value = law.exponent,
            .standard_error = std::hypot(law.error, by_threshold),
            .n = law.forces,
            .note = "fitted to the forces above the threshold found by the search"};
  }

  PushCurve curve_;
  RunGroup thresholds_;
  Scenario push_;
  double height_ = 0;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_velocity_experiment() { return std::make_unique<Velocity>(); }

}  // namespace quicksand
