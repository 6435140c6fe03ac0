// After a push, the weight above the intruder and the force that takes it out, bonds restored.
#include "app/experiments/experiments.h"
#include "app/json/json_reader.h"
#include "core/measures/linear_fit.h"

namespace quicksand {

namespace {

class PullOut : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    curve_ = jobs.push_curve(jobs.samples());
    for (std::size_t k = 0; k < curve_.forces.size(); ++k)
      pulls_.push_back(jobs.pulls(curve_.pushes[k], curve_.forces[k]));
    cohesion_ = *jobs.jobs()[pulls_[0].runs[0]].scenario.grain_law.cohesion_force;
  }

  void report(const PaperResults& results, Section& section, Findings& findings) const override {
    Curve pull{.name = "pull-out force (left)"};
    Curve weight = curve_over(results, "weight above the intruder (right)", curve_.forces,
                              curve_.pushes, "weight_above_level");
    weight.second_axis = true;
    Table table{.caption =
                    "Pull-out after all bonds were restored. The force is the midpoint of the "
                    "interval that contains the critical force.",
                .columns = {{"push force [F_c]", true},
                            {"pull-out force [F_c]", true},
                            {"pull-out over push", true},
                            {"still moving at the lower end", true},
                            {"weight above, by height", true},
                            {"weight above, by column", true}}};
    std::optional<Measured> largest;
    for (std::size_t k = 0; k < curve_.forces.size(); ++k) {
      const double push = curve_.forces[k];
      const auto force = results.critical_force(pulls_[k], cohesion_);
      const auto ratio = results.critical_force(pulls_[k], cohesion_ * push);
      if (ratio && (!largest || ratio->value > largest->value)) largest = ratio;
      add_point(pull, push, force);
      table.rows.push_back({{.text = number_text(push)},
                            cell_of(force, all_),
                            cell_of(ratio, all_),
                            {.text = std::to_string(results.unbracketed(pulls_[k]))},
                            cell_of(results.mean(curve_.pushes[k], "weight_above_level"), all_),
                            cell_of(results.mean(curve_.pushes[k], "weight_above_column"), all_)});
    }
    section.add(std::move(table));
    note(findings, "penetration.pull_out_over_push", largest);
    note_slope(findings, "penetration.pull_out_slope", pull);
    note_slope(findings, "penetration.weight_above_slope", weight);
    Plot plot{.name = "pull_out",
              .x = {.label = "push force", .unit = "F_c"},
              .y = {.label = "pull-out force", .unit = "F_c", .low = 0},
              .y2 = Axis{.label = "weight above / total weight", .low = 0, .high = 1}};
    add_limit_of_paper(plot);
    plot.curves.push_back(std::move(pull));
    plot.curves.push_back(std::move(weight));
    section.add(
        Figure{std::move(plot),
               "Left axis: the force that pulls the intruder out; right axis: the share of the "
               "grains' weight that lies above its centre. Bars are one standard error."});
  }

 private:
  // The paper's largest pull-out force over the push, as a line.
  void add_limit_of_paper(Plot& plot) const {
    const PaperTargets targets = read_targets(shipped_targets());
    const Target& most = targets.at("penetration.pull_out_over_push");
    const double deepest = curve_.forces.back();
    plot.curves.push_back({.name = "paper: " + most.printed + " times the push (left)",
                           .kind = Curve::Kind::line,
                           .role = Curve::Role::paper,
                           .x = {0, deepest},
                           .y = {0, *most.high * deepest}});
  }

  // Its error is that of the line, or what the errors of the means make of it, if that is larger.
  static void note_slope(Findings& findings, const std::string& id, const Curve& curve) {
    const auto line = fit_line(curve.x, curve.y);
    if (!line) return;
    findings[id] = {.value = line->slope,
                    .standard_error = std::max(line->slope_error.value_or(0),
                                               slope_error_by(curve.x, curve.y_error)),
                    .n = static_cast<int>(curve.x.size()),
                    .note = "slope of a straight line through the means"};
  }

  PushCurve curve_;
  std::vector<RunGroup> pulls_;
  double cohesion_ = 1;  // [F_g]
};

}  // namespace

std::unique_ptr<PaperExperiment> make_pull_out_experiment() { return std::make_unique<PullOut>(); }

}  // namespace quicksand
