// An intruder pushed in with a constant force: depth, bonds, coordination numbers, by regions.
#include <cmath>

#include "app/experiments/experiments.h"
#include "app/experiments/push_course.h"
#include "app/experiments/strong_push.h"
#include "app/json/json_reader.h"
#include "app/paper/outcome_table.h"
#include "core/base/errors.h"
#include "render/base/palette.h"

namespace quicksand {

namespace {

// The forces of the paper's snapshots; that of the third, its "strong" one, it does not give.
constexpr double kWeak = 0.33, kEqual = 1;

constexpr FinalQuantity kShown[] = {{"depth", "depth [d]"},
                                    {"active_bond_fraction", "active share"},
                                    {"remaining_bond_fraction", "remaining share"},
                                    {"coordination", "coordination number"},
                                    {"coordination_loaded", "coordination, with a force or a bond"},
                                    {"coordination_within_1e-3", "coordination, gaps below 1e-3 d"},
                                    {"coordination_within_1e-2", "coordination, gaps below 1e-2 d"},
                                    {"channel_active_bond_fraction", "channel: active"},
                                    {"channel_coordination", "channel: coordination number"},
                                    {"intact_active_bond_fraction", "intact: active"},
                                    {"intact_coordination", "intact: coordination number"}};

class Penetration : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    height_ = jobs.scale().height;
    curve_ = jobs.push_curve(jobs.samples());
  }

  void report(const PaperResults& results, Section& section, Findings& findings) const override {
    const auto strong = strong_push(results, curve_);
    add_pictures(results, strong, section);
    std::vector<OutcomeRow> rows;
    for (std::size_t k = 0; k < curve_.forces.size(); ++k)
      rows.push_back({number_text(curve_.forces[k]), curve_.pushes[k]});
    section.add(outcome_table(results,
                              "At the end of each push, at rest or after its max_time. Channel: "
                              "the grains where the intruder has passed; intact: those farther "
                              "than six intruder diameters from its trajectory.",
                              {"push force [F_c]", true}, rows, kShown, all_));
    add_plots(results, section);
    add_push_course(section, results, curve_, height_, all_);
    compare(results, findings);
    if (strong) compare_strong(results, *strong, findings);
  }

 private:
  void add_pictures(const PaperResults& results, const std::optional<StrongPush>& strong,
                    Section& section) const {
    for (std::size_t k = 0; k < curve_.forces.size(); ++k) {
      if (curve_.forces[k] != kWeak && curve_.forces[k] != kEqual &&
          !(strong && strong->index == k))
        continue;
      add_snapshots(section, results, curve_.pushes[k],
                    "pushed with " + number_text(curve_.forces[k]) + " × cohesion force");
    }
  }

  // The paper's strong force has no number, it is beyond F_c: its points stand on a bar over such forces, to the right
  // of ours.
  double strong_place() const { return 1.25 * std::max(kEqual, curve_.forces.back()); }
  double largest_shown() const { return 1.5 * std::max(kEqual, curve_.forces.back()); }

  // What is the paper's stands a little to the right of its force, or it would hide ours.
  static constexpr double kAside = 1.08;

  // The paper's shares, open and in the colour of ours, which are the curve of this style.
  Curve paper_shares(std::size_t style, const std::string& name,
                     const std::string& quantity) const {
    const double none = std::nan("");
    return {.name = "paper: " + name,
            .role = Curve::Role::paper,
            .style = style,
            .colour = kCurveColours[style],
            .x = {kAside * kWeak, kAside * kEqual, strong_place()},
            .y = {*paper_push("0.33", quantity).low, *paper_push("1.0", quantity).low,
                  *paper_push("strong", quantity).low},
            .x_error = {none, none, strong_place() - kEqual}};
  }

  void add_plots(const PaperResults& results, Section& section) const {
    // One for all, with the paper's values for its weakest and its strong push in it.
    const Axis force{.label = "push force",
                     .unit = "F_c",
                     .low = 0.9 * std::min(kWeak, curve_.forces.front()),
                     .high = largest_shown(),
                     .logarithmic = true};
    add_bonds(results, force, section);
    add_share_pairs(section, results, curve_);
    add_depth(results, force, section);
    add_contacts(results, force, section);
  }

  void add_bonds(const PaperResults& results, const Axis& force, Section& section) const {
    Plot bonds{.name = "penetration_bonds",
               .x = force,
               .y = {.label = "share of bonds", .low = 0, .high = 1.02}};
    add_with_band(bonds, curve_over(results, "active share", curve_.forces, curve_.pushes,
                                    "active_bond_fraction"));
    add_with_band(bonds, curve_over(results, "remaining share", curve_.forces, curve_.pushes,
                                    "remaining_bond_fraction"));
    bonds.curves.push_back(paper_shares(0, "active share", "active_of_contacts"));
    bonds.curves.push_back(paper_shares(1, "remaining share", "remaining_of_initial"));
    section.add(Figure{
        std::move(bonds),
        "Shares of bonds after the push as a function of its force, with bands of one standard "
        "error. Open symbols: the paper's values, shifted a little to the right. The paper gives "
        "no number for its strong force; the bars span all forces above F_c."});
  }

  void add_depth(const PaperResults& results, const Axis& force, Section& section) const {
    Plot depth{.name = "penetration_depth",
               .x = force,
               .y = {.label = "depth of the intruder", .unit = "d", .low = 0},
               .references = {
                   {.name = "height of the box", .low = height_, .role = Reference::Role::guide}}};
    depth.curves.push_back(curve_over(results, "ours", curve_.forces, curve_.pushes, "depth"));
    const Target bottom = paper_push("1.0", "depth");
    const double middle = (*bottom.low + 1) / 2 * height_;
    depth.curves.push_back({.name = "paper: " + bottom.words,
                            .role = Curve::Role::paper,
                            .x = {kAside * kEqual},
                            .y = {middle},
                            .y_error = {height_ - middle}});
    section.add(
        Figure{std::move(depth),
               "Final depth of the intruder's lowest point, with bars of one standard error. The "
               "paper gives no number; its words for F_c are drawn as the range from " +
                   number_text(*bottom.low) + " of the height to the full height."});
  }

  void add_contacts(const PaperResults& results, const Axis& force, Section& section) const {
    Plot contacts{
        .name = "penetration_coordination", .x = force, .y = {.label = "coordination number"}};
    for (const auto& [name, quantity] : {std::pair{"with a force or a bond", "coordination_loaded"},
                                         std::pair{"gap up to d_c", "coordination"},
                                         std::pair{"gap up to 10⁻³ d", "coordination_within_1e-3"},
                                         std::pair{"gap up to 10⁻² d", "coordination_within_1e-2"}})
      add_with_band(contacts, curve_over(results, name, curve_.forces, curve_.pushes, quantity));
    contacts.curves.push_back({.name = "paper",
                               .role = Curve::Role::paper,
                               .x = {strong_place()},
                               .y = {*paper_push("strong", "coordination").low},
                               .x_error = {strong_place() - kEqual}});
    section.add(Figure{
        std::move(contacts),
        "Coordination number after the push as a function of its force, with bands of one standard "
        "error: of the contacts that carry a force or a bond, and of all pairs up to three gaps. "
        "The paper says neither what it counts nor how large its strong force is; the bar spans "
        "all forces above F_c."});
  }

  void compare(const PaperResults& results, Findings& findings) const {
    for (std::size_t k = 0; k < curve_.forces.size(); ++k) {
      if (curve_.forces[k] != kWeak && curve_.forces[k] != kEqual) continue;
      const std::string push = curve_.forces[k] == kWeak ? "penetration.0.33." : "penetration.1.0.";
      note(findings, push + "active_of_contacts",
           results.mean(curve_.pushes[k], "active_bond_fraction"));
      note(findings, push + "remaining_of_initial",
           results.mean(curve_.pushes[k], "remaining_bond_fraction"));
      if (curve_.forces[k] != kEqual) continue;
      std::vector<double> shares;
      for (const RunResults* run : results.runs(curve_.pushes[k]))
        if (const auto depth = run->final_value("depth"))
          shares.push_back(*depth / run->column("packing_top").front());
      note(findings, push + "depth", mean_over(shares));
    }
  }

  void compare_strong(const PaperResults& results, const StrongPush& strong,
                      Findings& findings) const {
    for (const auto& [id, quantity] :
         {std::pair{"active_of_contacts", "active_bond_fraction"},
          {"remaining_of_initial", "remaining_bond_fraction"},
          {"coordination", "coordination"},
          {"channel.active_of_contacts", "channel_active_bond_fraction"},
          {"channel.coordination", "channel_coordination"},
          {"intact.active_of_contacts", "intact_active_bond_fraction"},
          {"intact.coordination", "intact_coordination"}}) {
      auto found = results.mean(curve_.pushes[strong.index], quantity);
      if (found) found->note = strong.note;
      note(findings, std::string("penetration.strong.") + id, found);
    }
  }

  PushCurve curve_;
  double height_ = 0;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_penetration_experiment() {
  return std::make_unique<Penetration>();
}

}  // namespace quicksand
