#include "app/experiments/push_course.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "app/json/json_reader.h"

namespace quicksand {

namespace {

constexpr double kHalfWay = 0.5, kFloor = 0.95;  // over the box's height
constexpr std::array kCounted{"active_bond_fraction",         "remaining_bond_fraction",
                              "channel_active_bond_fraction", "channel_coordination",
                              "intact_active_bond_fraction",  "intact_coordination"};

// A moment of a push: the row of its series, if it comes to it.
using Moment = std::function<std::optional<std::size_t>(const RunResults& push)>;

// The first row from `from` on in which a column is at least this.
std::optional<std::size_t> first_row(const RunResults& push, const char* column, double least,
                                     std::size_t from = 0) {
  if (!push.has_column(column)) return std::nullopt;
  const std::vector<double>& values = push.column(column);
  for (std::size_t row = from; row < values.size(); ++row)
    if (values[row] >= least) return row;
  return std::nullopt;
}

// The intruder's lowest point has first come this deep.
Moment at_depth(double depth) {
  return [=](const RunResults& push) { return first_row(push, "depth", depth); };
}

// Behind an intruder that has reached the floor, the channel holds half of the grains that it will hold at rest.
Moment half_filled(double floor) {
  return [=](const RunResults& push) -> std::optional<std::size_t> {
    const auto bottom = first_row(push, "depth", floor);
    if (!bottom || !push.has_column("channel_grains")) return std::nullopt;
    return first_row(push, "channel_grains", push.column("channel_grains").back() / 2, *bottom);
  };
}

std::optional<std::size_t> at_rest(const RunResults& push) {
  const std::size_t rows = push.has_column("time") ? push.column("time").size() : 0;
  return rows == 0 ? std::nullopt : std::optional(rows - 1);
}

std::optional<Measured> mean_at(const PaperResults& results, const RunGroup& pushes,
                                const Moment& moment, const char* quantity) {
  std::vector<double> values;
  for (const RunResults* run : results.runs(pushes))
    if (const auto row = moment(*run); row && run->has_column(quantity)) {
      const double value = run->column(quantity)[*row];
      if (std::isfinite(value)) values.push_back(value);  // or there is no such region
    }
  return mean_over(values);
}

Table table_of(const PaperResults& results, const PushCurve& curve, double height, int all) {
  Table table{
      .caption =
          "The same when the intruder's lowest point is half-way down the box, when it is at a "
          "depth of 0.95 of the box's height, when behind it the channel has collapsed so far that "
          "it holds half of the grains that it holds in the end, and at rest.",
      .columns = {{"push force [F_c]", true}, {"moment"}}};
  for (const char* title :
       {"active share", "remaining share", "channel: active share", "channel: coordination number",
        "intact: active share", "intact: coordination number"})
    table.columns.push_back({title, true});
  const std::pair<const char*, Moment> moments[] = {
      {"half-way down", at_depth(kHalfWay * height)},
      {"at the floor", at_depth(kFloor * height)},
      {"channel half filled", half_filled(kFloor * height)},
      {"at rest", at_rest}};
  for (std::size_t k = 0; k < curve.forces.size(); ++k)
    for (const auto& [name, moment] : moments) {
      std::vector<Cell> row{{number_text(curve.forces[k])}, {name}};
      for (const char* quantity : kCounted)
        row.push_back(cell_of(mean_at(results, curve.pushes[k], moment, quantity), all));
      table.rows.push_back(std::move(row));
    }
  return table;
}

// The time from the push's begin up to which all runs are known: where the first was stopped while something moved, or
// else where the last has come to rest [sqrt(d/g)].
double known_until(const PaperResults& results, const RunGroup& pushes) {
  double all_at_rest = 0, stopped = HUGE_VAL;
  for (const RunResults* run : results.runs(pushes)) {
    const std::vector<double>& times = run->column("time");
    if (times.empty()) continue;
    const double length = times.back() - times.front();
    all_at_rest = std::max(all_at_rest, length);
    if (run->summary().value("missed_rest", false)) stopped = std::min(stopped, length);
  }
  return std::min(all_at_rest, stopped);
}

// Means over realizations at times from the push's begin; a run that has come to rest keeps its last value.
Curve over_time(const PaperResults& results, const RunGroup& pushes, const std::string& name) {
  constexpr double kFirst = 0.1;  // [sqrt(d/g)]
  constexpr int kTimes = 60;
  const double last = known_until(results, pushes);
  Curve curve{.name = name, .kind = Curve::Kind::line};
  for (int k = 0; k <= kTimes && last > kFirst; ++k) {
    const double time = kFirst * std::pow(last / kFirst, static_cast<double>(k) / kTimes);
    std::vector<double> values;
    for (const RunResults* run : results.runs(pushes)) {
      const std::vector<double>& times = run->column("time");
      if (times.empty() || !run->has_column(kCounted[0])) continue;
      const auto after = std::ranges::upper_bound(times, times.front() + time);
      values.push_back(
          run->column(kCounted[0])[static_cast<std::size_t>(after - times.begin()) - 1]);
    }
    add_point(curve, time, mean_over(values));
  }
  return curve;
}

// At the mean of the times when the intruder reaches the floor, on the mean course.
Curve at_the_floor(const PaperResults& results, const RunGroup& pushes, const Curve& course,
                   double height) {
  std::vector<double> times;
  for (const RunResults* run : results.runs(pushes))
    if (const auto row = first_row(*run, "depth", kFloor * height))
      times.push_back(run->column("time")[*row] - run->column("time").front());
  Curve point{.style = course.style};
  const auto time = mean_over(times);
  if (!time) return point;
  const auto next = std::ranges::lower_bound(course.x, time->value);
  if (next == course.x.begin() || next == course.x.end()) return point;
  const auto k = static_cast<std::size_t>(next - course.x.begin());
  const double share = (time->value - course.x[k - 1]) / (course.x[k] - course.x[k - 1]);
  point.x = {time->value};
  point.y = {std::lerp(course.y[k - 1], course.y[k], share)};
  return point;
}

// Of the paper's forces the same in every plot, however many of them are computed.
std::size_t style_of_force(double force, std::size_t otherwise) {
  const std::vector<double> all = PaperScale{}.push_forces;
  const auto known = std::ranges::find(all, force);
  return known == all.end() ? all.size() + otherwise
                            : static_cast<std::size_t>(known - all.begin());
}

}  // namespace

void add_push_course(Section& section, const PaperResults& results, const PushCurve& curve,
                     double height, int all) {
  section.add(table_of(results, curve, height, all));
  Plot plot{.name = "penetration_course",
            .x = {.label = "time since the push began", .unit = "√(d/g)", .logarithmic = true},
            .y = {.label = "active share of contacts", .low = 0, .high = 1.02}};
  std::vector<Curve> symbols;
  for (std::size_t k = 0; k < curve.forces.size(); ++k) {
    Curve course = over_time(results, curve.pushes[k], number_text(curve.forces[k]) + " F_c");
    course.style = style_of_force(curve.forces[k], k);
    symbols.push_back(at_the_floor(results, curve.pushes[k], course, height));
    add_with_band(plot, std::move(course));
  }
  // One of them stands for all in the legend.
  const auto first = std::ranges::find_if(symbols, [](const Curve& c) { return !c.x.empty(); });
  if (first != symbols.end()) first->name = "intruder near the floor";
  std::ranges::move(symbols, std::back_inserter(plot.curves));
  section.add(
      Figure{std::move(plot),
             "Active share of contacts over time for each push force, with bands of one standard "
             "error. Symbols: the intruder reaches a depth of 0.95 of the box's height. The "
             "channel collapses after that. A line ends where all specimens have come to rest, or "
             "where the first was stopped while something was still moving."});
}

}  // namespace quicksand
