#include "app/experiments/push_course.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/json/json_reader.h"

namespace quicksand {

namespace {

constexpr double kHalfWay = 0.5, kFloor = 0.95;  // over the box's height
constexpr std::array kCounted{"active_bond_fraction", "remaining_bond_fraction",
                              "intact_active_bond_fraction", "intact_coordination"};

// The row in which the intruder's lowest point has first come this deep.
std::optional<std::size_t> row_at(const RunResults& push, double depth) {
  if (!push.has_column("depth")) return std::nullopt;
  const std::vector<double>& depths = push.column("depth");
  const auto first = std::ranges::find_if(depths, [&](double d) { return d >= depth; });
  if (first == depths.end()) return std::nullopt;
  return static_cast<std::size_t>(first - depths.begin());
}

std::optional<Measured> mean_at(const PaperResults& results, const RunGroup& pushes, double depth,
                                const char* quantity) {
  std::vector<double> values;
  for (const RunResults* run : results.runs(pushes))
    if (const auto row = row_at(*run, depth)) values.push_back(run->column(quantity)[*row]);
  return mean_over(values);
}

Table table_of(const PaperResults& results, const PushCurve& curve, double height, int all) {
  Table table{.caption =
                  "The same with the intruder's lowest point half-way down the box, at 0.95 of its "
                  "height, and at rest, when the channel has fallen in.",
              .columns = {{"push force [F_c]", true}, {"intruder"}}};
  for (const char* title :
       {"active share", "remaining share", "intact: active share", "intact: coordination number"})
    table.columns.push_back({title, true});
  for (std::size_t k = 0; k < curve.forces.size(); ++k)
    for (const auto& [where, depth] : {std::pair{"half-way down", kHalfWay * height},
                                       {"at the floor", kFloor * height},
                                       {"at rest", HUGE_VAL}}) {
      std::vector<Cell> row{{number_text(curve.forces[k])}, {where}};
      for (const char* quantity : kCounted)
        row.push_back(cell_of(std::isfinite(depth)
                                  ? mean_at(results, curve.pushes[k], depth, quantity)
                                  : results.mean(curve.pushes[k], quantity),
                              all));
      table.rows.push_back(std::move(row));
    }
  return table;
}

// Means over realizations at times from the push's begin; a run that has come to rest keeps its last value.
Curve over_time(const PaperResults& results, const RunGroup& pushes, const std::string& name) {
  constexpr double kFirst = 0.1, kLast = 50;  // [sqrt(d/g)]
  constexpr int kTimes = 60;
  Curve curve{.name = name, .kind = Curve::Kind::line};
  for (int k = 0; k <= kTimes; ++k) {
    const double time = kFirst * std::pow(kLast / kFirst, static_cast<double>(k) / kTimes);
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

// Where the intruder reaches the floor, in the colour of the curve before; not in the legend, which is full.
Curve at_the_floor(const PaperResults& results, const RunGroup& pushes, double height) {
  std::vector<double> times, shares;
  for (const RunResults* run : results.runs(pushes))
    if (const auto row = row_at(*run, kFloor * height)) {
      times.push_back(run->column("time")[*row] - run->column("time").front());
      shares.push_back(run->column(kCounted[0])[*row]);
    }
  Curve point{.role = Curve::Role::fit};
  if (const auto time = mean_over(times)) add_point(point, time->value, mean_over(shares));
  return point;
}

}  // namespace

void add_push_course(Section& section, const PaperResults& results, const PushCurve& curve,
                     double height, int all) {
  section.add(table_of(results, curve, height, all));
  Plot plot{.name = "penetration_course",
            .title = "Bonds during the push and after",
            .x = {.label = "time since the push began", .unit = "√(d/g)", .logarithmic = true},
            .y = {.label = "active share of contacts", .low = 0, .high = 1.02}};
  for (std::size_t k = 0; k < curve.forces.size(); ++k) {
    add_with_band(plot, over_time(results, curve.pushes[k],
                                  number_text(curve.forces[k]) + " × cohesion force"));
    plot.curves.push_back(at_the_floor(results, curve.pushes[k], height));
  }
  section.add(
      Figure{std::move(plot),
             "Active share of contacts over time, with bands of one standard error; symbols: "
             "the intruder comes to 0.95 of the box's height. The channel falls in after "
             "that."});
}

}  // namespace quicksand
