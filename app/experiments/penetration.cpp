// An intruder pushed in with a constant force: depth, bonds, coordination numbers, by regions.
#include "app/experiments/experiments.h"
#include "app/experiments/push_course.h"
#include "app/json/json_reader.h"
#include "app/paper/outcome_table.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

// The forces of the paper's three snapshots; the last stands for its "strong" one.
constexpr double kWeak = 0.33, kEqual = 1, kStrong = 3;

constexpr FinalQuantity kShown[] = {{"depth", "depth [d]"},
                                    {"active_bond_fraction", "active share"},
                                    {"remaining_bond_fraction", "remaining share"},
                                    {"coordination", "coordination number"},
                                    {"coordination_within_1e-3", "of gaps below 1e-3 d"},
                                    {"coordination_within_1e-2", "of gaps below 1e-2 d"},
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
    add_pictures(results, section);
    std::vector<OutcomeRow> rows;
    for (std::size_t k = 0; k < curve_.forces.size(); ++k)
      rows.push_back({number_text(curve_.forces[k]), curve_.pushes[k]});
    section.add(outcome_table(
        results,
        "At the end of each push: at rest, or after its max_time. Channel: where the "
        "intruder has passed; intact: farther from its path than six of its diameters.",
        {"push force [F_c]", true}, rows, kShown, all_));
    add_plots(results, section);
    add_push_course(section, results, curve_, height_, all_);
    for (std::size_t k = 0; k < curve_.forces.size(); ++k) compare(results, k, findings);
  }

 private:
  void add_pictures(const PaperResults& results, Section& section) const {
    for (std::size_t k = 0; k < curve_.forces.size(); ++k) {
      if (curve_.forces[k] != kWeak && curve_.forces[k] != kEqual && curve_.forces[k] != kStrong)
        continue;
      add_snapshots(section, results, curve_.pushes[k],
                    "pushed with " + number_text(curve_.forces[k]) + " × cohesion force");
    }
  }

  static Curve paper_curve(const std::string& name, const std::string& quantity) {
    const PaperTargets targets = read_targets(shipped_targets());
    Curve curve{.name = name, .role = Curve::Role::paper, .x = {kWeak, kEqual, kStrong}};
    for (const char* force : {"0.33", "1.0", "strong"})
      curve.y.push_back(*targets.at("penetration." + std::string(force) + "." + quantity).low);
    return curve;
  }

  void add_plots(const PaperResults& results, Section& section) const {
    const auto ours = [&](Plot& plot, const char* name, const char* quantity) {
      add_with_band(plot, curve_over(results, name, curve_.forces, curve_.pushes, quantity));
    };
    const Axis force{.label = "push force", .unit = "F_c", .logarithmic = true};
    Plot bonds{.name = "penetration_bonds",
               .title = "Bonds after the push",
               .x = force,
               .y = {.label = "share", .low = 0, .high = 1.02}};
    ours(bonds, "active share", "active_bond_fraction");
    ours(bonds, "remaining share", "remaining_bond_fraction");
    bonds.curves.push_back(paper_curve("paper: active share", "active_of_contacts"));
    bonds.curves.push_back(paper_curve("paper: remaining share", "remaining_of_initial"));
    section.add(
        Figure{std::move(bonds),
               "Shares of bonds against the push force, with bands of one standard error. The "
               "paper's strong force has no number; its points are drawn at 3 F_c."});
    Plot depth{.name = "penetration_depth",
               .title = "Depth of the intruder",
               .x = force,
               .y = {.label = "depth", .unit = "d", .low = 0},
               .references = {
                   {.name = "height of the box", .low = height_, .role = Reference::Role::guide}}};
    ours(depth, "depth", "depth");
    const PaperTargets targets = read_targets(shipped_targets());
    const Target& bottom = targets.at("penetration.1.0.depth");
    const double middle = (*bottom.low + 1) / 2 * height_;
    depth.curves.push_back({.name = "paper: " + bottom.words,
                            .role = Curve::Role::paper,
                            .x = {kEqual},
                            .y = {middle},
                            .y_error = {height_ - middle}});
    section.add(
        Figure{std::move(depth),
               "Final depth of the intruder's lowest point, with a band of one standard error. The "
               "paper gives no number: its words at F_c are drawn as " +
                   number_text(*bottom.low) + " of the height to all of it."});
    Plot contacts{.name = "penetration_coordination",
                  .title = "Contacts of a grain after the push",
                  .x = force,
                  .y = {.label = "coordination number"}};
    ours(contacts, "gap up to d_c", "coordination");
    ours(contacts, "gap up to 1e-3 d", "coordination_within_1e-3");
    ours(contacts, "gap up to 1e-2 d", "coordination_within_1e-2");
    contacts.curves.push_back({.name = "paper",
                               .role = Curve::Role::paper,
                               .x = {kStrong},
                               .y = {*targets.at("penetration.strong.coordination").low}});
    section.add(
        Figure{std::move(contacts),
               "Coordination number against the push force, by the gap up to which a pair counts "
               "as a contact, with bands of one standard error. The paper does not say which; its "
               "strong force has no number and is drawn at 3 F_c."});
  }

  void compare(const PaperResults& results, std::size_t k, Findings& findings) const {
    const auto find = [&](const std::string& id, const char* quantity) {
      note(findings, id, results.mean(curve_.pushes[k], quantity));
    };
    if (curve_.forces[k] == kWeak) {
      find("penetration.0.33.active_of_contacts", "active_bond_fraction");
      find("penetration.0.33.remaining_of_initial", "remaining_bond_fraction");
    } else if (curve_.forces[k] == kEqual) {
      find("penetration.1.0.active_of_contacts", "active_bond_fraction");
      find("penetration.1.0.remaining_of_initial", "remaining_bond_fraction");
      std::vector<double> shares;
      for (const RunResults* run : results.runs(curve_.pushes[k]))
        if (const auto depth = run->final_value("depth"))
          shares.push_back(*depth / run->column("packing_top").front());
      note(findings, "penetration.1.0.depth", mean_over(shares));
    } else if (curve_.forces[k] == kStrong) {
      const std::string strong = "penetration.strong.";
      find(strong + "active_of_contacts", "active_bond_fraction");
      find(strong + "remaining_of_initial", "remaining_bond_fraction");
      find(strong + "coordination", "coordination");
      find(strong + "channel.active_of_contacts", "channel_active_bond_fraction");
      find(strong + "channel.coordination", "channel_coordination");
      find(strong + "intact.active_of_contacts", "intact_active_bond_fraction");
      find(strong + "intact.coordination", "intact_coordination");
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
