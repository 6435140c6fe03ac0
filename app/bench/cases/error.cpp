// Error of a run against its cost: what time step, tolerance and failure criterion do to the observables of a
// small push, against the run that is finest in all of them.
//
// Runs are chaotic, so only means over seeds are compared. All settings start from the same deposits,
// hence the difference to the finest run is taken seed by seed, and its scatter gives the standard error.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <span>

#include "app/base/assets.h"
#include "app/bench/bench.h"
#include "app/scene/scene_file.h"
#include "core/measures/linear_fit.h"
#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"

namespace quicksand::bench {

namespace {

constexpr const char* kReference = "reference";

struct Setting {
  std::string name;
  double dt = 1e-3;
  double tolerance = 1e-6;
  FailureCriterion rule = FailureCriterion::energy;
};

// The first is what the others are compared with.
std::vector<Setting> settings() {
  using enum FailureCriterion;
  return {{kReference, 1e-4, 1e-7},
          {"energy", 1e-2},
          {"energy", 3e-3},
          {"energy", 1e-3},
          {"energy", 5e-4},
          {"energy", 2.5e-4},
          {"energy", 1e-3, 1e-3},
          {"energy", 1e-3, 1e-4},
          {"energy", 1e-3, 1e-5},
          {"energy", 1e-3, 1e-7},
          {"linearised", 3e-3, 1e-6, linearised},
          {"linearised", 1e-3, 1e-6, linearised},
          {"geometric", 3e-3, 1e-6, geometric},
          {"geometric", 1e-3, 1e-6, geometric}};
}

struct Observable {
  const char* name;
  double (*get)(const Sample&);
};
constexpr std::array kObservables{
    Observable{"broken bonds", [](const Sample& s) { return static_cast<double>(s.bonds_broken); }},
    Observable{"depth", [](const Sample& s) { return s.depth; }},
    Observable{"volume fraction", [](const Sample& s) { return s.volume_fraction.value_or(0); }},
    Observable{"coordination", [](const Sample& s) { return s.coordination; }},
    Observable{"active share", [](const Sample& s) { return s.active_bond_fraction.value_or(0); }}};

Scenario push_scene(const Options& options) {
  const bool quick = options.quick;
  return read_scene({.file = shipped_scene("collapse"),
                     .overrides = {quick ? "box.width=16" : "box.width=24",
                                   quick ? "box.height=28" : "box.height=40",
                                   quick ? "phases[0].height=22" : "phases[0].height=34",
                                   quick ? "phases[1].max_time=0.15" : "phases[1].max_time=0.2"}});
}

void advance_to_phase(Protocol& protocol, int phase) {
  while (protocol.state().phase < phase) {
    stop_if_interrupted();
    const Progress progress = protocol.advance();
    if (progress == Progress::failed) throw std::runtime_error(protocol.failure());
    if (progress == Progress::finished) return;
  }
}

// All settings from the deposit of one seed.
void run_seed(int seed, const Options& options, std::vector<Row>& rows) {
  Scenario scene = push_scene(options);
  scene.seed = static_cast<std::uint64_t>(seed);
  Protocol deposit(scene, make_world(scene));
  advance_to_phase(deposit, 1);
  for (const Setting& setting : settings()) {
    Scenario varied = scene;
    varied.phases.resize(2);
    varied.phases[1].dt = setting.dt;
    varied.phases[1].solver_tolerance = setting.tolerance;
    varied.step.break_rule = setting.rule;
    Row row{.name = "push", .method = setting.name, .repeat = seed};
    const Stopwatch watch;
    Protocol push(varied, deposit.world(), deposit.state());
    advance_to_phase(push, 2);
    row.seconds = watch.elapsed();
    row.size = push.world().disks.size();
    row.contacts = static_cast<std::int64_t>(push.world().contacts.size());
    row.tolerance = setting.tolerance;
    row.dt = setting.dt;
    row.steps = push.world().step - deposit.world().step;
    row.factorisations = push.state().factorisations - deposit.state().factorisations;
    row.iterations = push.state().iterations - deposit.state().iterations;
    row.unconverged = push.state().halved_steps - deposit.state().halved_steps;
    row.residual = push.state().worst_residual;
    row.unit = "";
    const Sample sample = measure(push.world());
    for (const Observable& observable : kObservables) {
      row.what = observable.name;
      row.value = observable.get(sample);
      rows.push_back(row);
      row.seconds = {};  // of the run, not of each observable
    }
  }
}

// What was found with one setting.
struct Found {
  const Row* row = nullptr;
  double seconds = 0;  // mean over seeds
  std::map<std::string, std::map<int, double>> values;
};

std::vector<Found> found_in(std::span<const Row> rows) {
  std::vector<Found> all;
  for (const Row& row : rows) {
    if (!row.value) continue;
    auto found = std::ranges::find_if(all, [&](const Found& f) {
      return f.row->method == row.method && f.row->dt == row.dt &&
             f.row->tolerance == row.tolerance;
    });
    if (found == all.end()) found = all.insert(all.end(), Found{.row = &row});
    found->values[row.what][row.repeat] = *row.value;
    found->seconds += row.seconds.cpu;
  }
  for (Found& found : all)
    found.seconds /= static_cast<double>(found.values.begin()->second.size());
  return all;
}

// Mean difference to the reference over the reference's mean, with its standard error.
Mean deviation(const Found& found, const Found& reference, const std::string& observable) {
  std::vector<double> differences, right;
  const std::map<int, double>& of_reference = reference.values.at(observable);
  for (const auto& [seed, value] : found.values.at(observable)) {
    const auto same = of_reference.find(seed);
    if (same == of_reference.end()) continue;
    differences.push_back(value - same->second);
    right.push_back(same->second);
  }
  const double scale = std::abs(mean_of(right)->value);
  Mean mean = *mean_of(differences);
  if (scale == 0) return {.value = mean.value == 0 ? 0 : HUGE_VAL};
  mean.value /= scale;
  if (mean.error) *mean.error /= scale;
  return mean;
}

std::string setting_text(const Row& row) {
  return row.method + format(", dt %g, tolerance %g", row.dt, row.tolerance);
}

// The cheapest setting of the default rule within the bound, where the standard error does not hide it.
std::string needed(const std::vector<Found>& all, const std::string& observable, double bound) {
  const Found* cheapest = nullptr;
  bool hidden = false;
  for (const Found& found : all) {
    if (found.row->method != "energy") continue;
    const Mean off = deviation(found, all.front(), observable);
    if (std::abs(off.value) > bound) continue;
    if (std::abs(off.value) + off.error.value_or(HUGE_VAL) > bound) {
      hidden = true;
      continue;
    }
    if (cheapest == nullptr || found.seconds < cheapest->seconds) cheapest = &found;
  }
  if (cheapest == nullptr)
    return hidden ? "not decided: the scatter of the seeds is larger" : "none of these";
  return setting_text(*cheapest->row) + format(" (%.2g s)", cheapest->seconds);
}

// The text of a point whose bar has this half length.
struct PointLabel {
  Annotation text;
  double bar = 0;
};

// In shares of the graph.
struct Rectangle {
  double left = 0, right = 0, bottom = 0, top = 0;
  double shared(const Rectangle& other) const {
    return std::max(0.0, std::min(right, other.right) - std::max(left, other.left)) *
           std::max(0.0, std::min(top, other.top) - std::max(bottom, other.bottom));
  }
};

// Each is centred above the bar of its point, or below it where other labels, points and bars are less in its way.
void add_labels(Plot& plot, std::vector<PointLabel> labels) {
  constexpr double kCharacter = 1.0 / 58, kLine = 1.0 / 14;  // about their size, over the graph's
  constexpr double kOffset = 0.6;   // at which a label begins, in characters
  constexpr double kMarker = 0.01;  // half its size
  const auto x_of = [](const PointLabel& label) { return label.text.x; };
  const double first = std::log(std::ranges::min(labels, {}, x_of).text.x);
  const double width = std::log(*plot.x.high) - first;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const auto& [label, bar] : labels) {
    low = std::min(low, label.y - bar);
    high = std::max(high, label.y + bar);
  }
  const auto across = [&](double x) { return (std::log(x) - first) / width; };
  const auto up = [&](double y) { return (y - low) / (high - low); };
  std::vector<Rectangle> taken;
  for (const Curve& curve : plot.curves)
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      taken.push_back({across(curve.x[k]) - kMarker, across(curve.x[k]) + kMarker,
                       up(curve.y[k] - curve.y_error[k]) - kMarker,
                       up(curve.y[k] + curve.y_error[k]) + kMarker});
  // From the top: what has moved below is in the way of those that come later.
  std::ranges::sort(labels, std::greater{}, [](const PointLabel& label) { return label.text.y; });
  for (PointLabel& entry : labels) {
    auto& label = entry.text;
    const double bar = entry.bar;
    const double half = kCharacter * static_cast<double>(label.text.size()) / 2;
    const double left = std::max(across(label.x) - half, -kCharacter);
    const auto place = [&](bool below) {
      const double bottom =
          below ? up(label.y - bar) - kMarker - kLine : up(label.y + bar) + kMarker;
      return Rectangle{left, left + 2 * half, bottom, bottom + kLine};
    };
    const auto covered = [&](const Rectangle& at) {
      double area = 0;
      for (const Rectangle& other : taken) area += at.shared(other);
      return area;
    };
    label.below = covered(place(true)) < covered(place(false));
    taken.push_back(place(label.below));
    label.x = std::exp(first + width * (left - kOffset * kCharacter));
    label.y += label.below ? -bar : bar;
    plot.annotations.push_back(std::move(label));
  }
}

Plot cost_plot(const std::vector<Found>& all, const std::string& observable, const char* name) {
  Plot plot{.name = name,
            .title = observable + " against the reference run",
            .x = {.label = "CPU time of the push, mean", .unit = "s", .logarithmic = true},
            .y = {.label = "mean deviation", .unit = "%"}};
  std::vector<PointLabel> labels;
  const auto add = [&](const std::string& text, const std::string& rule, bool usual_tolerance) {
    Curve curve{.name = text};
    for (const Found& found : all) {
      const Row& row = *found.row;
      if (row.method != rule || (row.tolerance == Setting{}.tolerance) != usual_tolerance) continue;
      const Mean off = deviation(found, all.front(), observable);
      curve.x.push_back(found.seconds);
      curve.y.push_back(100 * off.value);
      curve.y_error.push_back(100 * off.error.value_or(0));
      if (usual_tolerance)
        labels.push_back(
            {{curve.x.back(), curve.y.back(), format("%g", row.dt)}, curve.y_error.back()});
    }
    if (!curve.x.empty()) plot.curves.push_back(std::move(curve));
  };
  for (const std::string rule : {"energy", "linearised", "geometric"})
    add(rule + " criterion, with dt", rule, true);
  add("energy criterion at dt = 0.001, other tolerances", "energy", false);
  constexpr double kRoomForLabels = 1.4;
  plot.x.high =
      kRoomForLabels * std::ranges::max(std::span(all).subspan(1), {}, &Found::seconds).seconds;
  if (!labels.empty()) add_labels(plot, std::move(labels));
  plot.references.push_back({.low = -5, .high = 5, .role = quicksand::Reference::Role::guide});
  return plot;
}

}  // namespace

std::vector<Task> error_tasks(const Options& options) {
  const int seeds = options.repeats_or(options.quick ? 8 : 16);
  std::vector<Task> tasks;
  for (int seed = 1; seed <= seeds; ++seed)
    tasks.push_back({format("push, seed %d", seed),
                     [seed, options](std::vector<Row>& rows) { run_seed(seed, options, rows); }});
  return tasks;
}

void report_error(std::span<const Row> rows, const Options&, Section& section) {
  const std::vector<Found> all = found_in(rows);
  if (all.empty() || all.front().row->method != kReference) return;
  const Found& reference = all.front();
  const std::size_t seeds = reference.values.begin()->second.size();
  section.add(Paragraph{
      format("An intruder is pushed with F_c into a loose packing of about %lld grains, for so "
             "short a time that it is still on its way. Each setting is run from the same %zu "
             "deposits. The reference is the energy criterion at dt = %g and a tolerance of %g; "
             "deviations are means over the seeds, with standard errors, in percent of the "
             "reference's mean. The reference is no exact solution: it has its own time step.",
             static_cast<long long>(reference.row->size), seeds, reference.row->dt,
             reference.row->tolerance)});
  Table table{.caption = "Deviation from the reference [%]",
              .columns = {{"setting"}, {"seconds", true}}};
  Table need{.caption =
                 "The cheapest setting of the energy criterion whose deviation, with its standard "
                 "error, stays below",
             .columns = {{"observable"}, {"reference", true}, {"5 %"}, {"1 %"}}};
  for (const Observable& observable : kObservables)
    table.columns.push_back({observable.name, true});
  for (const Found& found : all) {
    if (&found == &reference) continue;
    std::vector<Cell> cells{{setting_text(*found.row)}, {format("%.3g", found.seconds)}};
    for (const Observable& observable : kObservables) {
      const Mean off = deviation(found, reference, observable.name);
      cells.push_back({format("%+.1f ± %.1f", 100 * off.value, 100 * off.error.value_or(0))});
    }
    table.rows.push_back(std::move(cells));
  }
  for (const Observable& observable : kObservables) {
    std::vector<double> values;
    for (const auto& [seed, value] : reference.values.at(observable.name)) values.push_back(value);
    const Mean mean = *mean_of(values);
    need.rows.push_back({{observable.name},
                         {format("%.4g ± %.1g", mean.value, mean.error.value_or(0))},
                         {needed(all, observable.name, 0.05)},
                         {needed(all, observable.name, 0.01)}});
  }
  section.add(Paragraph{format("The reference takes %.3g s a push.", reference.seconds)});
  section.add(std::move(table));
  section.add(std::move(need));
  constexpr const char* kCaption =
      "Bars are standard errors over the seeds; grey: within 5 %. Steps are dt at most: they are "
      "halved until no bonded pair turns farther than max_turn.";
  if (seeds < 2) {
    section.add(Remark{Remark::Kind::warning, "One seed has no standard error."});
    return;
  }
  section.add(quicksand::Figure{cost_plot(all, "broken bonds", "error_broken_bonds"), kCaption});
  section.add(quicksand::Figure{cost_plot(all, "depth", "error_depth"), kCaption});
}

}  // namespace quicksand::bench
