// The field experiment's shear strengths beside the simulation's in SI units.
//
// A vane in the field measures a stress, the simulation a force on one grain. The force is spread over
// the grain's square, tau = F/d^2, with d and the weight of a grain, a sphere, from the scenes.
#include "app/experiments/experiments.h"
#include "app/paper/paper_strength.h"
#include "app/plot/typeset_number.h"
#include "app/scene_json/si_scale.h"
#include "core/scene/scenario.h"

namespace quicksand {

namespace {

constexpr double kCentimetre = 100;

class FieldExperiment : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    runs_ = plan_strength(jobs);
    physical_ = *jobs.jobs()[runs_.loose.runs.front()].scenario.physical;
  }

  void report(const PaperResults& results, Section& section, Findings& findings) const override {
    const SiScale si = si_scale(physical_);
    const double depth = si.length * kCentimetre;
    const double stress = si.force / (si.length * si.length) * kKilopascals;
    const PaperStrength loose = paper_strength(results, runs_.loose),
                        compact = paper_strength(results, runs_.compact);
    section.add(Paragraph{
        "A force F on a grain is converted to the stress F/d² with d = " +
        typeset(physical_.grain_diameter * 1e6) + " µm and grains of " +
        typeset(physical_.grain_density) +
        " kg/m³. This density is an assumption, to which all stresses are proportional. The "
        "simulated specimens are only " +
        "centimetres high; the lines of the field experiment are drawn over the same depth."});
    Plot plot{.name = "field",
              .x = {.label = "depth", .unit = "cm", .low = 0},
              .y = {.label = "shear strength", .unit = "kPa", .low = 0}};
    const PaperTargets targets = read_targets(shipped_targets());
    const Target& fitted = targets.at("field.perturbed.slope");
    const double slope = (*fitted.low + *fitted.high) / 2;                  // [kPa/cm]
    const double strength = *targets.at("field.unperturbed.strength").low;  // [kPa]
    double deepest = 0;
    for (const PaperStrength* ours : {&loose, &compact}) {
      if (!ours->depth.empty()) deepest = std::max(deepest, ours->depth.back() * depth);
      const char* name = ours == &loose ? "unperturbed" : "perturbed";
      add_strength(plot, *ours, name, depth, stress);
    }
    if (deepest > 0) {
      plot.curves.push_back({.name = "field, perturbed: " + typeset(slope) + " kPa/cm",
                             .kind = Curve::Kind::line,
                             .role = Curve::Role::paper,
                             .x = {0, deepest},
                             .y = {0, slope * deepest}});
      plot.references.push_back(
          {.name = "field, unperturbed: " + typeset(strength) + " kPa", .low = strength});
    }
    section.add(Figure{std::move(plot),
                       "Shear strength in SI units. Black: lines of the field experiment. Colour: "
                       "means of the simulation with bars of one standard error, and straight-line "
                       "fits to all grains (dashed)."});
    if (compact.against_depth) {
      const Line& fit = *compact.against_depth;
      const double scale = stress / depth;
      findings["field.perturbed.slope"] = {
          .value = fit.slope * scale,
          .standard_error =
              fit.slope_error ? std::optional(*fit.slope_error * scale) : std::nullopt,
          .n = compact.grains};
    }
    if (loose.level)
      findings["field.unperturbed.strength"] = {
          .value = loose.level->value * stress,
          .standard_error =
              loose.level->error ? std::optional(*loose.level->error * stress) : std::nullopt,
          .n = loose.grains};
    if (const auto constant = loose.constant_down_to())
      findings["field.unperturbed.constant_to_depth"] = {
          .value = *constant * depth,
          .n = loose.grains,
          .note =
              "all strengths down to this depth agree within two standard errors; the deepest was "
              "measured at " +
              typeset(loose.depth.back() * depth) + " cm"};
  }

 private:
  StrengthRuns runs_;
  PhysicalScale physical_;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_field_experiment() {
  return std::make_unique<FieldExperiment>();
}

}  // namespace quicksand
