// Shear strength over depth: unperturbed specimens, and specimens perturbed by the piston.
#include <algorithm>

#include "app/experiments/experiments.h"
#include "app/json/json_reader.h"
#include "app/paper/paper_strength.h"
#include "app/plot/typeset_number.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

Measured measured(const Mean& found, const PaperStrength& strength) {
  std::string note;
  if (strength.unbracketed > 0)
    note = std::to_string(strength.unbracketed) + " of " + std::to_string(strength.grains) +
           " grains were still moving slowly when the trial at the interval's lower end ran out of "
           "time";
  if (strength.never_moved > 0)
    note += (note.empty() ? "" : "; ") + std::to_string(strength.never_moved) +
            " more were not moved by any force";
  return {.value = found.value, .standard_error = found.error, .n = strength.grains, .note = note};
}

Mean slope_of(const Line& line) { return {line.slope, line.slope_error}; }

std::string line_text(const std::optional<Line>& line, double Line::*value,
                      std::optional<double> Line::*error) {
  return line ? typeset_with_error((*line).*value, (*line).*error) : "-";
}

class Shear : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    runs_ = plan_strength(jobs);
    scale_ = jobs.scale();
    scene_ = jobs.jobs()[runs_.loose.runs.front()].scenario;
  }

  void report(const PaperResults& results, Section& section, Findings& findings) const override {
    const PaperStrength loose = paper_strength(results, runs_.loose),
                        weak = paper_strength(results, runs_.weak),
                        strong = paper_strength(results, runs_.strong),
                        compact = paper_strength(results, runs_.compact),
                        rough = paper_strength(results, runs_.compact_rough);
    section.add(Paragraph{
        "A grain counts as moved if it has travelled " + number_text(scale_.shear_distance) +
        " d within " + number_text(scale_.shear_time) +
        " sqrt(d/g); the paper requires 20 d. Its strength is the midpoint between the largest "
        "force that did not move it and the smallest that did, once their distance is at most " +
        number_text(scale_.shear_tolerance) + " of the latter. Strengths are measured for " +
        count_text(scale_.grains_per_depth, "grain") +
        " per depth and specimen; the paper uses 10. Time steps are " +
        number_text(scene_.step.dt) + " sqrt(d/g)."});
    section.add(table({{"unperturbed, F_c = 10² F_g", &weak},
                       {"unperturbed, F_c = 10⁴ F_g", &loose},
                       {"unperturbed, F_c = 10⁶ F_g", &strong},
                       {"perturbed, friction 0.3", &compact},
                       {"perturbed, friction 0.6", &rough}}));
    if (loose.against_depth && !weak.depth.empty())
      section.add(Paragraph{about_weak_bonds(loose, weak)});
    const std::vector<Named> unperturbed{
        {"F_c = 10² F_g", &weak}, {"F_c = 10⁴ F_g", &loose}, {"F_c = 10⁶ F_g", &strong}};
    const auto measured_ones =
        std::ranges::count_if(unperturbed, [](const Named& s) { return s.second->grains > 0; });
    const bool decades = measured_ones > 1;  // between their strengths
    if (measured_ones > 0)
      section.add(Figure{
          plot("shear_unperturbed",
               {.label = "shear strength", .unit = "F_g", .logarithmic = decades}, unperturbed),
          std::string("Smallest horizontal force that moves a grain of an unperturbed specimen: "
                      "means with bars of one standard error over grains, and straight-line fits "
                      "to all grains (dashed") +
              (decades ? ", curved by the logarithmic axis" : "") +
              "). The paper gives no numbers here."});
    if (compact.grains + rough.grains > 0) {
      Plot perturbed = plot("shear_perturbed", {.label = "shear strength", .unit = "F_g", .low = 0},
                            {{"friction 0.3", &compact}, {"friction 0.6", &rough}});
      add_lines_of_paper(perturbed, std::max(compact.depth.empty() ? 0 : compact.depth.back(),
                                             rough.depth.empty() ? 0 : rough.depth.back()));
      section.add(Figure{std::move(perturbed),
                         "The same after compaction by the piston. Black: the paper's lines, which "
                         "are zero at the surface."});
    }
    compare_perturbed(compact, rough, findings);
    compare_unperturbed(loose, strong, compact, findings);
  }

 private:
  using Named = std::pair<const char*, const PaperStrength*>;

  static Table table(const std::vector<Named>& all) {
    Table table{.caption =
                    "Straight-line fits of the strength against depth. Effective friction: slope "
                    "of the strength against the weight of all grains above.",
                .columns = {{"specimen"},
                            {"slope [F_g/d]", true},
                            {"at the surface [F_g]", true},
                            {"effective friction", true},
                            {"grains", true},
                            {"still moving at the lower end", true},
                            {"never moved", true}}};
    for (const auto& [name, strength] : all)
      if (strength->grains > 0)
        table.rows.push_back(
            {{.text = name},
             {.text = line_text(strength->against_depth, &Line::slope, &Line::slope_error)},
             {.text = line_text(strength->against_depth, &Line::intercept, &Line::intercept_error)},
             {.text = line_text(strength->against_weight, &Line::slope, &Line::slope_error)},
             {.text = std::to_string(strength->grains)},
             {.text = std::to_string(strength->unbracketed)},
             {.text = std::to_string(strength->never_moved)}});
    return table;
  }

  static Plot plot(const char* name, Axis strength_axis, const std::vector<Named>& all) {
    Plot plot{.name = name,
              .x = {.label = "depth", .unit = "d", .low = 0},
              .y = std::move(strength_axis)};
    for (const auto& [curve, strength] : all) add_strength(plot, *strength, curve);
    return plot;
  }

  // The paper's lines, over the depths of ours.
  static void add_lines_of_paper(Plot& plot, double deepest) {
    const PaperTargets targets = read_targets(shipped_targets());
    for (const char* friction : {"0.3", "0.6"}) {
      const double slope = *targets.at(std::string("shear.perturbed.slope.mu_") + friction).low;
      plot.curves.push_back(
          {.name = std::string("paper, friction ") + friction + ": " + typeset(slope) + " F_g/d",
           .kind = Curve::Kind::line,
           .role = Curve::Role::paper,
           .x = {0, deepest},
           .y = {0, slope * deepest}});
    }
  }

  static void compare_perturbed(const PaperStrength& compact, const PaperStrength& rough,
                                Findings& findings) {
    const auto line = [&](const std::string& id, const PaperStrength& s,
                          const std::optional<Line>& fit) {
      if (fit) findings[id] = measured(slope_of(*fit), s);
    };
    line("shear.perturbed.slope.mu_0.3", compact, compact.against_depth);
    line("shear.perturbed.slope.mu_0.6", rough, rough.against_depth);
    line("shear.perturbed.effective_friction.mu_0.3", compact, compact.against_weight);
    line("shear.perturbed.effective_friction.mu_0.6", rough, rough.against_weight);
    if (compact.against_depth && rough.against_depth)
      findings["shear.perturbed.slope_ratio"] = measured(
          quotient(slope_of(*rough.against_depth), slope_of(*compact.against_depth)), rough);
    if (compact.against_depth)
      findings["shear.perturbed.intercept"] =
          measured(compact.line_ratio(0, compact.depth.back()), compact);
  }

  static void compare_unperturbed(const PaperStrength& loose, const PaperStrength& strong,
                                  const PaperStrength& compact, Findings& findings) {
    if (loose.against_depth) {
      findings["shear.unperturbed.intercept"] =
          measured(loose.line_ratio(0, loose.level_depth), loose);
      if (compact.against_depth)
        findings["shear.unperturbed.slope"] = measured(
            quotient(slope_of(*loose.against_depth), slope_of(*compact.against_depth)), loose);
    }
    if (loose.level && strong.level)
      findings["shear.unperturbed.cohesion_effect"] =
          measured(quotient(*strong.level, *loose.level), strong);
  }

  static std::string about_weak_bonds(const PaperStrength& loose, const PaperStrength& weak) {
    const double depth = weak.level_depth;
    return "The paper says that a hundredfold cohesion force changes the unperturbed strength "
           "little. The table of numbers takes this to mean 10⁴ and 10⁶ F_g. The paper may instead "
           "mean 10² and 10⁴, since it gives the density of a specimen made with 10², whose bonds "
           "are so weak that it collapses until it is dense. At the mean depth of its grains, " +
           typeset(depth) + " d, its mean strength is " + typeset(weak.level->value) +
           " F_g, and the line for 10⁴ gives " +
           typeset(loose.against_depth->intercept + loose.against_depth->slope * depth) +
           " F_g there.";
  }

  StrengthRuns runs_;
  PaperScale scale_;
  Scenario scene_;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_shear_experiment() { return std::make_unique<Shear>(); }

}  // namespace quicksand
