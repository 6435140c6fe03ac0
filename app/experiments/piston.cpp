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

    constexpr FinalQuantity kLines[] = {{"packing_top", "height [d]"},
                                        {"volume_fraction", "volume fraction"},
                                        {"coordination", "coordination number"},
                                        {"coordination_loaded", "the same, with a force or a bond"},
                                        {"coordination_within_1e-3", "the same, gaps below 1e-3 d"},
                                        {"coordination_within_1e-2", "the same, gaps below 1e-2 d"},
                                        {"active_bond_fraction", "active share"},
                                        {"remaining_bond_fraction", "remaining share"}};
    Table table{
        .caption = "Before and after compaction by the piston, which is removed at the end.",
        .columns = {{"quantity"}, {"before", true}, {"after", true}}};
    for (const FinalQuantity& line : kLines)
      table.rows.push_back({{.text = line.title},
                            cell_of(results.mean(before_, line.quantity), all_),
                            cell_of(results.mean(after_, line.quantity), all_)});
    section.add(std::move(table));

    add_plots(results, section);

    note(findings, "piston.active_of_contacts", results.mean(after_, "active_bond_fraction"));
    note(findings, "piston.remaining_of_initial", results.mean(after_, "remaining_bond_fraction"));
    note_specimens(findings, results, before_);
    note(findings, "piston.after.coordination", results.mean(after_, "coordination"));
    note(findings, "piston.after.volume_fraction", results.mean(after_, "volume_fraction"));
    note(findings, "piston.after.height", results.mean(after_, "packing_top"));
  }

 private:
  void add_plots(const PaperResults& results, Section& section) const {
    const PaperTargets targets = read_targets(shipped_targets());
    const auto of_paper = [&](const char* name, const char* before, const char* after) {
      return Curve{
          .name = name,
          .role = Curve::Role::paper,
          .x = {*targets.at("piston.before.height").low, *targets.at("piston.after.height").low},
          .y = {*targets.at(before).low, *targets.at(after).low}};
    };
    const Axis height{.label = "height of the piston", .unit = "d"};
    Plot contacts{
        .name = "piston_coordination", .x = height, .y = {.label = "coordination number"}};
    add_course(contacts, results, "while the piston comes down", "coordination");
    contacts.curves.push_back(
        of_paper("paper", "piston.before.coordination", "piston.after.coordination"));
    section.add(
        Figure{std::move(contacts),
               "Mean coordination number while the piston comes down (from right to left), with a "
               "band of one standard error. Symbol: where the specimens settle once the piston has "
               "been removed. The paper's points are before and after compaction."});
    Plot bonds{
        .name = "piston", .x = height, .y = {.label = "share of bonds", .low = 0, .high = 1.02}};
    add_course(bonds, results, "active share", "active_bond_fraction");
    add_course(bonds, results, "remaining share", "remaining_bond_fraction");
    bonds.curves.push_back(of_paper("paper: active share", "unperturbed.active_bond_fraction",
                                    "piston.active_of_contacts"));
    bonds.curves.push_back({.name = "paper: remaining share",
                            .role = Curve::Role::paper,
                            .x = {*targets.at("piston.after.height").low},
                            .y = {*targets.at("piston.remaining_of_initial").low}});
    section.add(Figure{std::move(bonds),
                       "The same for the shares of bonds. Symbols: where the specimens settle once "
                       "the piston has been removed."});
  }

  // A line while the piston comes down, and in its colour a symbol where the specimens come to rest without it.
  void add_course(Plot& plot, const PaperResults& results, const char* name,
                  const char* quantity) const {
    Curve course = while_falling(results, quantity);
    course.name = name;
    add_with_band(plot, std::move(course));
    const auto height = results.mean(after_, "packing_top"), value = results.mean(after_, quantity);
    if (!height || !value) return;
    plot.curves.push_back({.role = Curve::Role::fit,
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
