// From the paper's method to exact steps: what sweeps and time step do to the bonds that a push leaves.
#include <algorithm>

#include "app/json/json_reader.h"
#include "app/plot/typeset_number.h"
#include "app/studies/figures.h"

namespace quicksand {

namespace {

constexpr int kSweeps[] = {10, 30, 100, 300, 1000};
constexpr double kSteps[] = {1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4};  // [sqrt(d/g)]
// What takes more sweeps in a unit of time is left out: a push of a specimen of the full box would take hours.
constexpr double kMostSweeps = 1e6;
// An exact step costs the more, the more of it is solved anew when bonds fail.
constexpr double kLeastExactStep = 2e-4;

struct PaperPush {
  double force;         // [F_c]
  const char* id;       // of the paper's targets
  const char* plotted;  // end of the plot's name
};
// The paper gives no number for its strong force.
constexpr PaperPush kPushes[] = {
    {0.33, "0.33", "weak"}, {1, "1.0", "equal"}, {10, "strong", "strong"}};

struct Share {
  const char* target;
  const char* quantity;
  const char* label;
};
constexpr Share kRemaining{"remaining_of_initial", "remaining_bond_fraction", "remaining share"},
    kActive{"active_of_contacts", "active_bond_fraction", "active share"};

// Pushes that differ by the time step only, the longest first.
struct Series {
  std::string name;
  std::vector<double> steps;
  std::vector<RunGroup> pushes;
};

// Values seed by seed, carried on to dt = 0 along the line through those of the two smallest steps.
std::optional<Measured> limit(const PaperResults& results, const Series& series,
                              const char* quantity) {
  const std::size_t k = series.steps.size() - 1;
  const double fine = series.steps[k], coarse = series.steps[k - 1];
  std::vector<double> limits;
  for (std::size_t seed = 0; seed < series.pushes[k].runs.size(); ++seed) {
    const auto end = [&](const RunGroup& group) -> std::optional<double> {
      const RunResults* run = results.run(group.runs[seed]);
      return run ? run->final_value(quantity) : std::nullopt;
    };
    const auto at_fine = end(series.pushes[k]), at_coarse = end(series.pushes[k - 1]);
    if (at_fine && at_coarse)
      limits.push_back(*at_fine + (*at_fine - *at_coarse) * fine / (coarse - fine));
  }
  return mean_over(limits);
}

class MethodMap : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    const RunGroup samples = jobs.samples();
    for (const PaperPush& push : kPushes) {
      std::vector<Series>& of_push = series_.emplace_back();
      for (const int sweeps : kSweeps) {
        Series& series = of_push.emplace_back(Series{std::to_string(sweeps) + " sweeps", {}, {}});
        for (const double dt : kSteps) {
          if (sweeps / dt > 1.001 * kMostSweeps) continue;
          NscdSetting setting;
          setting.sweeps = sweeps;
          setting.fast_step = dt;
          series.steps.push_back(dt);
          series.pushes.push_back(jobs.by(setting, samples.runs.size(), [&] {
            return jobs.pushes(samples, push.force,
                               "sweeps_" + std::to_string(sweeps) + "_dt_" + number_text(dt));
          }));
        }
      }
      Series& exact = of_push.emplace_back(Series{"exact steps", {}, {}});
      for (const double dt : kSteps) {
        if (dt < kLeastExactStep) continue;
        exact.steps.push_back(dt);
        exact.pushes.push_back(jobs.pushes(samples, push.force, "dt_" + number_text(dt), {}, dt));
      }
    }
    width_ = jobs.scale().width;
    height_ = jobs.scale().height;
  }

  void report(const PaperResults& results, Section& section, Findings&) const override {
    section.add(Paragraph{
        "Specimens of " + box_text({width_, height_}) +
        " made with exact steps, each pushed by NSCD with every number of sweeps and every time "
        "step, and by exact steps. Where the curves of NSCD meet, more sweeps change nothing; "
        "where a curve is level towards the left, smaller steps change nothing."});
    const PaperTargets targets = read_targets(shipped_targets());
    for (std::size_t p = 0; p < std::size(kPushes); ++p) add_plot(results, targets, p, section);
    for (const Share& share : {kRemaining, kActive}) add_table(results, targets, share, section);
    add_limits(results, section);
  }

 private:
  static const Target& target(const PaperTargets& targets, const PaperPush& push,
                              const Share& share) {
    return targets.at(std::string("penetration.") + push.id + "." + share.target);
  }

  void add_plot(const PaperResults& results, const PaperTargets& targets, std::size_t p,
                Section& section) const {
    const PaperPush& push = kPushes[p];
    const double paper = *target(targets, push, kRemaining).low;
    Plot plot{.name = std::string("map_") + push.plotted,
              .x = {.label = "time step", .unit = "sqrt(d/g)", .logarithmic = true},
              .y = {.label = kRemaining.label, .low = 0, .high = 1.02},
              .references = {{.name = "paper", .low = paper}}};
    // The more sweeps, the darker; exact steps come last.
    std::vector<Colour> colours = shades_of(method_colour("NSCD"), series_[p].size() - 1);
    colours.push_back(method_colour("exact"));
    for (std::size_t k = 0; k < colours.size(); ++k) {
      const Series& series = series_[p][k];
      Curve curve =
          curve_over(results, series.name, series.steps, series.pushes, kRemaining.quantity);
      curve.kind = Curve::Kind::line_points;
      curve.colour = colours[k];
      plot.curves.push_back(std::move(curve));
    }
    section.add(Figure{std::move(plot),
                       "Remaining share of the initial bonds after a push with " +
                           number_text(push.force) +
                           " F_c as a function of the time step: NSCD with different numbers of "
                           "sweeps, and exact steps. Bars are one standard error." +
                           (p == 2 ? " The paper gives no number for its strong force." : "")});
  }

  void add_table(const PaperResults& results, const PaperTargets& targets, const Share& share,
                 Section& section) const {
    Table table{.caption = std::string("After a push: ") + share.label + ".",
                .columns = {{"force [F_c]"}, {"method"}}};
    for (const double dt : kSteps) table.columns.push_back({"dt = " + typeset(dt), true});
    table.columns.push_back({"paper", true});
    for (std::size_t p = 0; p < std::size(kPushes); ++p)
      for (const Series& series : series_[p]) {
        std::vector<Cell> row{{number_text(kPushes[p].force)}, {series.name}};
        for (const double dt : kSteps) {
          const auto at = std::ranges::find(series.steps, dt);
          row.push_back(
              at == series.steps.end()
                  ? Cell{}
                  : cell_of(results.mean(
                                series.pushes[static_cast<std::size_t>(at - series.steps.begin())],
                                share.quantity),
                            all_));
        }
        row.push_back({paper_text(target(targets, kPushes[p], share))});
        table.rows.push_back(std::move(row));
      }
    section.add(std::move(table));
  }

  void add_limits(const PaperResults& results, Section& section) const {
    Table table{.caption = "Exact steps extrapolated to dt = 0.",
                .columns = {{"force [F_c]", true},
                            {"share"},
                            {"two smallest steps", true},
                            {"shares at these", true},
                            {"extrapolated to dt = 0", true}}};
    for (std::size_t p = 0; p < std::size(kPushes); ++p) {
      const Series& exact = series_[p].back();
      const std::size_t k = exact.steps.size() - 1;
      for (const Share& share : {kRemaining, kActive})
        table.rows.push_back(
            {{number_text(kPushes[p].force)},
             {share.label},
             {typeset(exact.steps[k - 1]) + ", " + typeset(exact.steps[k])},
             {cell_of(results.mean(exact.pushes[k - 1], share.quantity), all_).text + ", " +
              cell_of(results.mean(exact.pushes[k], share.quantity), all_).text},
             cell_of(limit(results, exact, share.quantity), all_)});
    }
    section.add(std::move(table));
    section.add(Paragraph{
        "The line through the values at the two smallest steps is extrapolated for each specimen; "
        "the error is that of the mean over specimens. Where the result differs from the values at "
        "these steps by more than two errors, the steps are too long to give a limit."});
  }

  std::vector<std::vector<Series>> series_;  // (pushes), exact steps last
  double width_ = 0, height_ = 0;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_method_map_experiment() {
  return std::make_unique<MethodMap>();
}

}  // namespace quicksand
