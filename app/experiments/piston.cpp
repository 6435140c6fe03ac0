// The specimen before and after a piston.
#include <algorithm>
#include <cmath>

#include "app/experiments/experiments.h"
#include "app/paper/outcome_table.h"

namespace quicksand {

namespace {

class Piston : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    before_ = jobs.samples();
    after_ = jobs.pistons(before_);
  }

  void report(const PaperResults& results, Section& section, Findings& findings) const override {
    add_snapshots(section, results, before_, "before the piston");
    add_snapshots(section, results, after_, "after the piston");

    constexpr FinalQuantity kLines[] = {
        {"packing_top", "height [d]"},
        {"volume_fraction", "volume fraction"},
        {"coordination", "coordination number"},
        {"coordination_within_1e-3", "the same, of gaps below 1e-3 d"},
        {"coordination_within_1e-2", "the same, of gaps below 1e-2 d"},
        {"active_bond_fraction", "active share"},
        {"remaining_bond_fraction", "remaining share"}};
    Table table{.caption = "Before and after the piston, which is taken away at the end.",
                .columns = {{"quantity"}, {"before", true}, {"after", true}}};
    for (const FinalQuantity& line : kLines)
      table.rows.push_back({{.text = line.title},
                            cell_of(results.mean(before_, line.quantity), all_),
                            cell_of(results.mean(after_, line.quantity), all_)});
    section.add(std::move(table));

    section.add(Figure{
        plot(results),
        "Means over realizations while the piston comes down, with bands of one standard "
        "error, and where the specimens settle once it has gone. The paper's points are those "
        "before and after."});

    note(findings, "piston.active_of_contacts", results.mean(after_, "active_bond_fraction"));
    note(findings, "piston.remaining_of_initial", results.mean(after_, "remaining_bond_fraction"));
    // They are the unperturbed ones: a part of the programme without the other depositions has these numbers, too.
    note(findings, "unperturbed.volume_fraction", results.mean(before_, "volume_fraction"));
    note(findings, "unperturbed.coordination", results.mean(before_, "coordination"));
    note(findings, "unperturbed.active_bond_fraction",
         results.mean(before_, "active_bond_fraction"));
    note(findings, "piston.before.coordination", results.mean(before_, "coordination"));
    note(findings, "piston.after.coordination", results.mean(after_, "coordination"));
    note(findings, "piston.before.volume_fraction", results.mean(before_, "volume_fraction"));
    note(findings, "piston.after.volume_fraction", results.mean(after_, "volume_fraction"));
    note(findings, "piston.before.height", results.mean(before_, "packing_top"));
    note(findings, "piston.after.height", results.mean(after_, "packing_top"));
  }

 private:
  Plot plot(const PaperResults& results) const {
    Plot plot{.name = "piston",
              .title = "Compaction by the piston",
              .x = {.label = "height of the piston", .unit = "d"},
              .y = {.label = "coordination number"},
              .y2 = Axis{.label = "active share", .low = 0, .high = 1.02}};
    Curve coordination = while_falling(results, "coordination");
    coordination.name = "coordination number (left)";
    Curve active = while_falling(results, "active_bond_fraction");
    active.name = "active share (right)";
    active.second_axis = true;
    add_with_band(plot, std::move(coordination));
    add_settled(plot, results, "coordination", false);
    add_with_band(plot, std::move(active));
    add_settled(plot, results, "active_bond_fraction", true);
    const PaperTargets targets = read_targets(shipped_targets());
    const auto paper = [&](const char* id) { return *targets.at(id).low; };
    const double before = paper("piston.before.height"), after = paper("piston.after.height");
    plot.curves.push_back(
        {.name = "paper: coordination number (left)",
         .role = Curve::Role::paper,
         .x = {before, after},
         .y = {paper("piston.before.coordination"), paper("piston.after.coordination")}});
    plot.curves.push_back(
        {.name = "paper: active share (right)",
         .role = Curve::Role::paper,
         .second_axis = true,
         .x = {before, after},
         .y = {paper("unperturbed.active_bond_fraction"), paper("piston.active_of_contacts")}});
    return plot;
  }

  // Where the specimens come to rest once the piston has gone, in the colour of the curve before.
  void add_settled(Plot& plot, const PaperResults& results, const char* quantity,
                   bool second_axis) const {
    const auto height = results.mean(after_, "packing_top"), value = results.mean(after_, quantity);
    if (!height || !value) return;
    plot.curves.push_back({.name = "the same, settled without it",
                           .role = Curve::Role::fit,
                           .second_axis = second_axis,
                           .x = {height->value},
                           .y = {value->value},
                           .x_error = {height->standard_error.value_or(0)},
                           .y_error = {value->standard_error.value_or(0)}});
  }

  // Means over realizations when the piston first passes a height, over heights that all of them pass.
  Curve while_falling(const PaperResults& results, const char* quantity) const {
    constexpr int kHeights = 60;
    double highest = HUGE_VAL, lowest = 0;
    for (const RunResults* run : results.runs(after_)) {
      double top = 0, bottom = HUGE_VAL;  // of the rows in which there is a piston
      for (const double y : run->column("piston_y")) {
        if (!std::isfinite(y)) continue;
        top = std::max(top, y);
        bottom = std::min(bottom, y);
      }
      highest = std::min(highest, top);
      lowest = std::max(lowest, bottom);
    }
    Curve curve{.kind = Curve::Kind::line};
    for (int k = 0; k <= kHeights && lowest < highest && highest < HUGE_VAL; ++k) {
      const double height = highest + (lowest - highest) * k / kHeights;
      std::vector<double> values;
      for (const RunResults* run : results.runs(after_)) {
        const std::vector<double>& heights = run->column("piston_y");
        const auto first = std::ranges::find_if(
            heights, [&](double y) { return std::isfinite(y) && y <= height * (1 + kRounding); });
        values.push_back(run->column(quantity)[static_cast<std::size_t>(first - heights.begin())]);
      }
      add_point(curve, height, mean_over(values));
    }
    return curve;
  }
  static constexpr double kRounding = 1e-12;

  RunGroup before_, after_;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_piston_experiment() { return std::make_unique<Piston>(); }

}  // namespace quicksand
