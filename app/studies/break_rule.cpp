// Pushes under each failure criterion with smaller and smaller time steps, in a looser and a denser specimen: which
// settings, if any, give all of the paper's numbers together.
//
// A coarse step lets the linearised rule hold bonds against impacts, and the energy and geometric rules break them;
// plain steps do both. What does not depend on the step is where the rules meet.
#include <algorithm>
#include <cmath>

#include "app/json/json_reader.h"
#include "app/plot/typeset_number.h"
#include "app/studies/figures.h"

namespace quicksand {

namespace {

struct Rule {
  const char* name;
  const char* tag;  // of its runs
  ParameterValues laws;
};
// The last is without what we add to contact dynamics: straight moves and a fixed step.
const std::vector<Rule>& rules() {
  static const std::vector<Rule> all{
      {"energy", "", {}},
      {"linearised", "linearised", {{"step.break_rule", "linearised"}}},
      {"geometric", "geometric", {{"step.break_rule", "geometric"}}},
      {"plain geometric",
       "plain",
       {{"step.break_rule", "geometric"},
        {"step.curvature_term", false},
        {"step.max_turn", nullptr}}}};
  return all;
}

// A force at which the paper gives numbers, and those.
struct KnownPush {
  double force;        // [F_c]
  const char* target;  // "penetration.<this>."
  const char* plot;    // of the files
  double tolerance;    // of what counts as given: about the range of specimens [1]
};
constexpr KnownPush kKnownPushes[] = {{0.33, "0.33", "0_33", 0.03}, {1, "1.0", "1", 0.05}};

struct KnownShare {
  const char* quantity;
  const char* target;
  const char* title;
};
constexpr KnownShare kKnownShares[] = {
    {"active_bond_fraction", "active_of_contacts", "active share"},
    {"remaining_bond_fraction", "remaining_of_initial", "remaining share"}};

std::string target_id(const KnownPush& push, const KnownShare& share) {
  return "penetration." + std::string(push.target) + "." + share.target;
}

// All forces with one specimen, rule and time step.
struct BreakSetting {
  std::size_t sample;
  std::string rule;
  double dt;                     // [sqrt(d/g)]
  std::vector<RunGroup> pushes;  // (forces)
};

// How far a setting is from the paper: its worst number, in tolerances. Above 1 is outside.
struct Distance {
  double tolerances = 0;
  std::string worst;
  bool complete = true;  // has all numbers
};

class BreakRules : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    samples_ = {jobs.samples()};
    if (jobs.scale().denser_if_quicker)
      samples_.push_back(jobs.samples(kDenseDeposition, {}, dense_deposition()));
    for (std::size_t s = 0; s < samples_.size(); ++s)
      for (const Rule& rule : rules())
        for (const double dt : jobs.scale().time_steps) plan_setting(jobs, s, rule, dt);
  }

  void report(const PaperResults& results, Section& section, Findings&) const override {
    section.add(
        Paragraph{"The same specimens, pushed until everything is at rest, with each failure "
                  "criterion and with smaller and smaller time steps. Where the results of a "
                  "criterion still change with the step, they are set by the step; the criteria "
                  "should agree where it is small. Plain geometric: without the curvature term and "
                  "with steps of one length, as in NSCD, which lacks these additions. It breaks a "
                  "bond that turns by more than √(2 d_c/d) in a step."});
    section.add(table_of(results));
    section.add(Paragraph{conclusion(results)});
    for (std::size_t p = 0; p < std::size(kKnownPushes); ++p)
      for (const KnownShare& share : kKnownShares) add_plot(results, p, share, section);
  }

 private:
  void plan_setting(PaperJobs& jobs, std::size_t sample, const Rule& rule, double dt) {
    BreakSetting setting{.sample = sample, .rule = rule.name, .dt = dt, .pushes = {}};
    // The reference, by the names that other figures give it.
    std::string tag = rule.tag;
    if (dt != jobs.scale().push_step) tag += (tag.empty() ? "dt_" : "_dt_") + number_text(dt);
    for (const KnownPush& push : kKnownPushes)
      setting.pushes.push_back(jobs.pushes(samples_[sample], push.force, tag, rule.laws, dt));
    settings_.push_back(std::move(setting));
  }

  std::string sample_text(const PaperResults& results, std::size_t sample) const {
    return "φ = " + cell_of(results.mean(samples_[sample], "volume_fraction"), all_).text;
  }

  Table table_of(const PaperResults& results) const {
    Table table{.caption =
                    "After the push, once everything is at rest, by the specimen's volume "
                    "fraction. Steps have length dt and are halved until no bonded pair turns by "
                    "more than max_turn; those of plain geometric are not halved.",
                .columns = {{"specimen"},
                            {"criterion"},
                            {"dt [√(d/g)]", true},
                            {"mean step [√(d/g)]", true},
                            {"push force [F_c]", true},
                            {"depth [d]", true},
                            {"active share", true},
                            {"remaining share", true},
                            {"intact: active", true},
                            {"coordination number", true}}};
    for (const BreakSetting& setting : settings_)
      for (std::size_t p = 0; p < setting.pushes.size(); ++p) {
        std::vector<Cell> row{{.text = sample_text(results, setting.sample)},
                              {.text = setting.rule},
                              {.text = number_text(setting.dt)},
                              {.text = mean_step(results, setting.pushes[p])},
                              {.text = number_text(kKnownPushes[p].force)}};
        for (const char* quantity : {"depth", "active_bond_fraction", "remaining_bond_fraction",
                                     "intact_active_bond_fraction", "coordination"})
          row.push_back(cell_of(results.mean(setting.pushes[p], quantity), all_));
        table.rows.push_back(std::move(row));
      }
    return table;
  }

  static std::string mean_step(const PaperResults& results, const RunGroup& group) {
    double time = 0, steps = 0;
    for (const RunResults* run : results.runs(group)) {
      time += run->column("time").back() - run->column("time").front();
      steps += *run->final_value("steps");
    }
    return steps > 0 ? typeset(time / steps, 2) : "-";
  }

  Distance distance_of(const PaperResults& results, const PaperTargets& targets,
                       const BreakSetting& setting) const {
    Distance distance;
    const auto compare = [&](const std::string& id, double tolerance,
                             const std::optional<Measured>& measured) {
      if (!measured) {
        distance.complete = false;
        return;
      }
      const Target& target = targets.at(id);
      const double off = std::abs(verdict_on(target, *measured).deviation) / tolerance;
      if (off <= distance.tolerances) return;
      distance.tolerances = off;
      distance.worst =
          target.quantity + ": " + typeset(measured->value) + " instead of " + paper_text(target);
    };
    for (std::size_t p = 0; p < std::size(kKnownPushes); ++p)
      for (const KnownShare& share : kKnownShares)
        compare(target_id(kKnownPushes[p], share), kKnownPushes[p].tolerance,
                results.mean(setting.pushes[p], share.quantity));
    return distance;
  }

  std::string conclusion(const PaperResults& results) const {
    const PaperTargets targets = read_targets(shipped_targets());
    const BreakSetting* nearest = nullptr;
    Distance least;
    for (const BreakSetting& setting : settings_) {
      const Distance distance = distance_of(results, targets, setting);
      if (!distance.complete || (nearest && distance.tolerances >= least.tolerances)) continue;
      nearest = &setting;
      least = distance;
    }
    if (!nearest) return "No setting has results for both forces yet.";
    const std::string which = "The " + nearest->rule +
                              " criterion with dt = " + number_text(nearest->dt) +
                              " in the specimen with " + sample_text(results, nearest->sample);
    if (least.tolerances <= 1)
      return which +
             " reproduces all four shares of bonds of the paper's pushes with 0.33 F_c and F_c, "
             "within 0.03 and 0.05.";
    return "No setting reproduces all four shares of bonds of the paper's pushes with 0.33 F_c and "
           "F_c. " +
           which + " comes closest; its worst number is " + typeset(least.tolerances, 2) +
           " tolerances (0.03 and 0.05) off (" + least.worst + ").";
  }

  void add_plot(const PaperResults& results, std::size_t push, const KnownShare& share,
                Section& section) const {
    const KnownPush& known = kKnownPushes[push];
    Plot plot{.name = "break_rule_" + std::string(known.plot) + "_" + share.target,
              .x = {.label = "dt", .unit = "√(d/g)", .logarithmic = true},
              .y = {.label = share.title, .low = 0, .high = 1.02}};
    const PaperTargets targets = read_targets(shipped_targets());
    const Target& target = targets.at(target_id(known, share));
    plot.references = {{.name = "paper", .low = *target.low, .high = *target.high}};
    for (std::size_t s = 0; s < samples_.size(); ++s)
      for (const Rule& rule : rules()) {
        Curve curve{.name = std::string(rule.name) + ", " + sample_text(results, s),
                    .kind = Curve::Kind::line_points};
        for (const BreakSetting& setting : settings_) {
          if (setting.sample != s || setting.rule != rule.name) continue;
          add_point(curve, setting.dt, results.mean(setting.pushes[push], share.quantity));
        }
        plot.curves.push_back(std::move(curve));
      }
    section.add(Figure{
        std::move(plot),
        "Bonds: " + std::string(share.title) +
            " as a function of the time step (the longest; the table has the mean); push force " +
            number_text(known.force) + " F_c."});
  }

  std::vector<RunGroup> samples_;
  std::vector<BreakSetting> settings_;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_break_rule_experiment() {
  return std::make_unique<BreakRules>();
}

}  // namespace quicksand
