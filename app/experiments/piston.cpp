// The specimen before and after a piston.
#include "app/experiments/experiments.h"

namespace quicksand {

namespace {

class Piston : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    before_ = jobs.samples();
    after_ = jobs.pistons(before_);
  }

  void report(const PaperResults& results, const std::filesystem::path& pictures, Section& section,
              Findings& findings) const override {
    Gallery gallery{.caption =
                        "The specimen before and after the piston, coloured by active bonds."};
    if (auto picture = picture_of(results, before_, pictures, "before"))
      gallery.pictures.push_back(*picture);
    if (auto picture = picture_of(results, after_, pictures, "after"))
      gallery.pictures.push_back(*picture);
    if (!gallery.pictures.empty()) section.add(std::move(gallery));

    struct Line {
      const char* quantity;
      const char* title;
    };
    constexpr Line kLines[] = {{"packing_top", "height [d]"},
                               {"volume_fraction", "volume fraction"},
                               {"coordination", "coordination number"},
                               {"coordination_within_1e-3", "the same, of gaps below 1e-3 d"},
                               {"coordination_within_1e-2", "the same, of gaps below 1e-2 d"},
                               {"active_bond_fraction", "active bonds of contacts"},
                               {"remaining_bond_fraction", "remaining of initial bonds"}};
    Table table{.caption = "Before and after the piston, which is taken away at the end.",
                .columns = {{"quantity"}, {"before", true}, {"after", true}}};
    for (const Line& line : kLines)
      table.rows.push_back({{.text = line.title},
                            cell_of(results.mean(before_, line.quantity), all_),
                            cell_of(results.mean(after_, line.quantity), all_)});
    section.add(std::move(table));

    Plot plot{.name = "piston",
              .title = "Compaction by the piston",
              .x = {.label = "height of the piston", .unit = "d"},
              .y = {.label = "coordination number"},
              .y2 = Axis{.label = "active bonds of contacts", .low = 0, .high = 1},
              .legend = LegendPlace::below};
    for (const RunResults* run : results.runs(after_)) {
      const bool first = plot.curves.empty();
      Curve coordination{.name = first ? "coordination number (left)" : "",
                         .kind = Curve::Kind::line};
      coordination.x = run->column("piston_y");
      coordination.y = run->column("coordination");
      Curve active = coordination;
      active.name = first ? "active bonds of contacts (right)" : "";
      active.y = run->column("active_bond_fraction");
      active.second_axis = true;
      plot.curves.push_back(std::move(coordination));
      plot.curves.push_back(std::move(active));
      break;
    }
    if (!plot.curves.empty())
      section.add(Figure{std::move(plot), "The first realization while the piston comes down."});

    note(findings, "piston.active_of_contacts", results.mean(after_, "active_bond_fraction"));
    note(findings, "piston.remaining_of_initial", results.mean(after_, "remaining_bond_fraction"));
    note(findings, "piston.before.coordination", results.mean(before_, "coordination"));
    note(findings, "piston.after.coordination", results.mean(after_, "coordination"));
    note(findings, "piston.before.volume_fraction", results.mean(before_, "volume_fraction"));
    note(findings, "piston.after.volume_fraction", results.mean(after_, "volume_fraction"));
    note(findings, "piston.before.height", results.mean(before_, "packing_top"));
    note(findings, "piston.after.height", results.mean(after_, "packing_top"));
  }

 private:
  RunGroup before_, after_;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_piston_experiment() { return std::make_unique<Piston>(); }

}  // namespace quicksand
