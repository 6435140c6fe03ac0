// The plots of a run's report.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "app/run_report/run_report.h"

namespace quicksand {

namespace {

struct TimeHistory {
  const char* quantity;  // column of series.csv
  const char* name;      // in the legend
};

// What is drawn over time. Several runs are compared by the first histories, each in a plot with one curve a run.
struct TimePlot {
  const char* name;
  const char* caption;  // of a single run
  Axis y;
  std::vector<TimeHistory> histories;
  Curve::Kind kind = Curve::Kind::line;
  bool per_step = false;  // sums since the last sample, which are not equally long apart
  bool has_tolerance = false;
  std::size_t compared = 1;
  const char* remark = "";  // behind every caption
};

constexpr const char* kOfSingleSteps =
    " Forces are those of the step before each sample, so that how high their peaks are depends on "
    "the time step and on the interval between samples.";

std::vector<TimePlot> time_plots() {
  return {
      {.name = "bonds",
       .caption = "Active bonds divided by touching contacts (active share) and by initial bonds "
                  "(remaining share).",
       .y = {.label = "share of bonds", .low = 0, .high = 1.05},
       .histories = {{"active_bond_fraction", "active share"},
                     {"remaining_bond_fraction", "remaining share"}},
       .compared = 2},
      {.name = "coordination",
       .caption = "Mean number of neighbours of a grain: those that touch it, and those with a "
                  "force or a bond.",
       .y = {.label = "coordination number"},
       .histories = {{"coordination", "touching"},
                     {"coordination_loaded", "with a force or a bond"}}},
      {.name = "volume_fraction",
       .caption = "Share of the area filled by disks in the lower 70 % of the packing.",
       .y = {.label = "volume fraction"},
       .histories = {{"volume_fraction", "volume fraction"}}},
      {.name = "intruder",
       .caption = "Heights of the intruder's centre and of the top of the packing.",
       .y = {.label = "height above the floor", .unit = "d", .low = 0},
       .histories = {{"intruder_y", "intruder's centre"}, {"packing_top", "top of the packing"}}},
      {.name = "stress",
       .caption = "Mean stress of the contact forces over the area of the packing, compression "
                  "positive.",
       .y = {.label = "mean stress", .unit = "F_g/d"},
       .histories = {{"stress_yy", "vertical"},
                     {"stress_xx", "horizontal"},
                     {"stress_xy", "shear"}},
       .remark = kOfSingleSteps},
      {.name = "loads",
       .caption = "Downward force of the contacts on the floor and on the sides, and normal force "
                  "on the piston.",
       .y = {.label = "force on the walls", .unit = "F_g"},
       .histories = {{"floor_load", "floor"}, {"side_load", "sides"}, {"piston_load", "piston"}},
       .remark = kOfSingleSteps},
      {.name = "kinetic_energy",
       .caption = "Kinetic energy of all disks and shaped bodies, of translation and of rotation.",
       .y = {.label = "kinetic energy", .unit = "F_g d", .logarithmic = true},
       .histories = {{"kinetic_energy", "translation"}, {"rotational_energy", "rotation"}}},
      {.name = "energy",
       .caption = "Work of gravity, forces and prescribed motion, and dissipated energy, since the "
                  "run began.",
       .y = {.label = "energy", .unit = "F_g d"},
       .histories = {{"energy_dissipated", "dissipated"}, {"external_work", "external work"}}},
      {.name = "residual",
       .caption = "Errors of the steps, the worst since the last sample. A step has converged if "
                  "both errors are below their tolerances (grey).",
       .y = {.label = "error of a step", .logarithmic = true},
       .histories = {{"residual", "residual"}, {"gap_error", "gap error over its tolerance"}},
       .has_tolerance = true},
      {.name = "factorisations",
       .caption = "Work of the solver: the mean since the last sample.",
       .y = {.label = "factorisations per step", .low = 0},
       .histories = {{"factorisations", "factorisations"}},
       .kind = Curve::Kind::steps,
       .per_step = true},
  };
}

// A value was there at least once.
bool has_values(const RunResults& run, const char* quantity) {
  return run.has_column(quantity) &&
         std::ranges::any_of(run.column(quantity), [](double v) { return std::isfinite(v); });
}

std::vector<double> values_of(const RunResults& run, const TimeHistory& history, bool per_step) {
  std::vector<double> values = run.column(history.quantity);
  if (!per_step) return values;
  const std::vector<double>& step = run.column("step");
  for (std::size_t i = values.size(); i-- > 0;) {
    const double steps = i > 0 ? step[i] - step[i - 1] : 0;
    values[i] = steps > 0 ? values[i] / steps : std::nan("");
  }
  return values;
}

// From the sample `first` on.
std::vector<double> from_sample(std::vector<double> values, std::size_t first) {
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
  return values;
}

// Counted from the sample `first`, or as they are if that is the beginning of all.
std::vector<double> times(const RunResults& run, std::size_t first, bool counted) {
  std::vector<double> time = from_sample(run.column("time"), first);
  const double zero = counted && !time.empty() ? time.front() : 0;
  for (double& t : time) t -= zero;
  return time;
}

// Samples at which a search has gone back to its stored state.
std::vector<std::size_t> returns_to_base(const RunResults& run, std::size_t first) {
  std::vector<std::size_t> samples;
  const std::vector<double>& trial = run.column("trial");
  for (std::size_t i = first + 1; i < trial.size(); ++i)
    if (std::isfinite(trial[i - 1]) && trial[i] != trial[i - 1]) samples.push_back(i - first);
  return samples;
}

// Where phases begin after the sample `first`; that at the beginning of all is before the first phase.
std::vector<Reference> phase_guides(const RunResults& run, std::size_t first,
                                    const std::vector<double>& time) {
  std::vector<Reference> guides;
  const std::vector<std::string>& phases = run.phases();
  for (std::size_t i = first + 2; i < phases.size(); ++i) {
    // The sample at the start of a phase belongs to the one before.
    if (phases[i] == phases[i - 1] || phases[i - 1] == "start") continue;
    guides.push_back({.name = phases[i],
                      .low = time[i - 1 - first],
                      .of_x = true,
                      .role = Reference::Role::guide});
  }
  return guides;
}

// The largest residuals of converged steps, of all phases, and the largest gap error; none by NSCD, which takes steps
// as they are.
std::vector<Reference> tolerance_guides(const RunResults& run) {
  const Json& scene = run.scene();
  if (!scene.is_object() || scene.value("method", "exact") == "nscd") return {};
  std::set<double> tolerances;
  const double usual = scene.value("solver", Json::object()).value("tolerance", 0.0);
  for (const Json& phase : scene.value("phases", Json::array()))
    tolerances.insert(phase.value("solver_tolerance", usual));
  tolerances.erase(0);
  std::vector<Reference> guides{{.low = 1, .role = Reference::Role::guide}};
  for (const double tolerance : tolerances)  // the name of the largest stands above all
    guides.push_back({.name = tolerance == *tolerances.rbegin() ? "tolerance of the residual" : "",
                      .low = tolerance,
                      .role = Reference::Role::guide});
  return guides;
}

// The load of a driven intruder over its way, where a phase drives one.
struct DrivePlot {
  const char* phase;  // whose samples count
  const char* caption;
  const char* way;  // column of series.csv
  Axis x, y;
  double sign;  // of the load
  Curve::Kind kind = Curve::Kind::points;
  std::vector<TimeHistory> histories;
};

std::vector<DrivePlot> drive_plots() {
  return {
      {.phase = "penetrate",
       .caption = "Upward force of the contacts on the intruder, in total and by the part of "
                  "its surface on which it acts.",
       .way = "depth",
       .x = {.label = "depth of the lowest point", .unit = "d"},
       .y = {.label = "resistance", .unit = "F_g"},
       .sign = 1,
       .histories = {{"resistance", "total"},
                     {"resistance_front", "front"},
                     {"resistance_flank", "flank"},
                     {"resistance_shaft", "shaft"}}},
      {.phase = "vane",
       .caption = "Torque of the contacts on the vane while it turns.",
       .way = "intruder_angle",
       .x = {.label = "angle", .unit = "rad"},
       .y = {.label = "torque against the rotation", .unit = "F_g d"},
       .sign = -1,
       .histories = {{"intruder_torque", "torque"}}},
      {.phase = "slide",
       .caption = "Horizontal force of the sliding piston on the bodies: means between samples.",
       .way = "piston_x",
       .x = {.label = "position of the piston along x", .unit = "d"},
       .y = {.label = "shear force", .unit = "F_g"},
       .sign = 1,
       .kind = Curve::Kind::line,
       .histories = {{"shear_force", "shear force"}}}};
}

// Empty if no run has such a phase.
std::optional<Plot> plot_of_drive(const DrivePlot& described, std::span<const RunResults> runs,
                                  const std::vector<std::string>& names) {
  const bool single = runs.size() == 1;
  Plot plot{.name = std::string(described.phase) + "_load", .x = described.x, .y = described.y};
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::vector<std::string>& phases = runs[r].phases();
    for (const TimeHistory& history : described.histories) {
      if (!has_values(runs[r], history.quantity)) continue;
      std::vector<double> way, load;
      const std::vector<double>& all_ways = runs[r].column(described.way);
      const std::vector<double>& all_loads = runs[r].column(history.quantity);
      for (std::size_t i = 0; i < phases.size(); ++i) {
        if (phases[i] != described.phase) continue;
        way.push_back(all_ways[i]);
        load.push_back(described.sign * all_loads[i]);
      }
      if (!way.empty())
        plot.curves.push_back({.name = single ? history.name : names[r],
                               .kind = described.kind,
                               .x = std::move(way),
                               .y = std::move(load)});
      if (!single) break;  // the sum alone
    }
  }
  if (plot.curves.empty()) return std::nullopt;
  return plot;
}

double highest(std::span<const Curve> curves) {
  double highest = -HUGE_VAL;
  for (const Curve& curve : curves)
    for (const double y : curve.y)
      highest = std::max(highest, y);  // not a number counts for nothing
  return highest;
}

// Samples between two interruptions of a line, which alone make no line; empty if there are none.
Curve lone_samples(const Curve& line) {
  Curve lone{.role = Curve::Role::fit};  // in the colour of the line
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    const auto begins = [&](std::size_t i) {
      return i == 0 || i == line.x.size() || std::ranges::binary_search(line.begins, i);
    };
    if (!begins(k) || !begins(k + 1)) continue;
    lone.x.push_back(line.x[k]);
    lone.y.push_back(line.y[k]);
  }
  return lone;
}

}  // namespace

std::vector<Figure> run_figures(std::span<const RunResults> runs, const std::string& from) {
  const std::vector<std::string> names = run_names(runs);
  const bool single = runs.size() == 1;
  std::vector<std::size_t> begins(runs.size(), 0);
  std::vector<std::vector<double>> time;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (!from.empty()) begins[r] = runs[r].begin_of(from);
    time.push_back(times(runs[r], begins[r], !from.empty()));
  }
  // The same range in all plots, though some histories begin late.
  Axis along{.low = HUGE_VAL, .high = -HUGE_VAL};
  for (const std::vector<double>& of_run : time)
    for (const double t : of_run)
      along = {.low = std::min(*along.low, t), .high = std::max(*along.high, t)};
  if (!(*along.high > *along.low)) along = {};
  along.label = from.empty() ? "time" : "time since " + from + " began";
  along.unit = "sqrt(d/g)";
  std::vector<Figure> figures;
  const auto add = [&](const TimePlot& described, std::span<const TimeHistory> histories) {
    // Without its main history a plot says nothing: there is no intruder.
    const auto main_history = [&](const RunResults& run) {
      return has_values(run, histories.front().quantity);
    };
    if (std::ranges::none_of(runs, main_history)) return;
    const bool first = &histories.front() == described.histories.data();
    Plot plot{
        .name = first ? described.name : histories.front().quantity, .x = along, .y = described.y};
    for (std::size_t r = 0; r < runs.size(); ++r)
      for (const TimeHistory& history : histories)
        if (has_values(runs[r], history.quantity)) {
          plot.curves.push_back(
              {.name = single ? history.name : names[r],
               .kind = described.kind,
               .x = time[r],
               .y = from_sample(values_of(runs[r], history, described.per_step), begins[r]),
               .begins = returns_to_base(runs[r], begins[r])});
          if (Curve lone = lone_samples(plot.curves.back()); !lone.x.empty())
            plot.curves.push_back(std::move(lone));
        }
    if (single) plot.references = phase_guides(runs.front(), begins.front(), time.front());
    if (described.has_tolerance && single)
      std::ranges::move(tolerance_guides(runs.front()), std::back_inserter(plot.references));
    // Active bonds may outnumber the contacts that touch.
    if (plot.y.high && highest(plot.curves) > *plot.y.high) plot.y.high.reset();
    std::string caption = described.caption;
    if (!single) {
      const std::string name = histories.front().name;
      if (plot.y.label.find(name) == std::string::npos) plot.y.label += ": " + name;
      caption = plot.y.label + ", one curve per run.";
      caption.front() =
          static_cast<char>(std::toupper(static_cast<unsigned char>(caption.front())));
    }
    figures.push_back({std::move(plot), caption + described.remark});
  };
  for (const TimePlot& described : time_plots()) {
    const std::span<const TimeHistory> histories = described.histories;
    if (single) {
      add(described, histories);
    } else {
      for (std::size_t k = 0; k < described.compared; ++k) add(described, histories.subspan(k, 1));
    }
  }
  for (const DrivePlot& described : drive_plots())
    if (std::optional<Plot> plot = plot_of_drive(described, runs, names))
      figures.push_back({*std::move(plot), described.caption});
  return figures;
}

}  // namespace quicksand
