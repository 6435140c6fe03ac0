// The goals as a part of the benchmark: each case a task, each figure a row with its verdict.
#include <algorithm>

#include "app/bench/goals/goal_cases.h"
#include "app/bench/statistics.h"

namespace quicksand::bench {

namespace {

constexpr const char* kFigure = "figure";
constexpr const char* kNote = "note";

// Whether the median reaches the goal and nothing besides speed is missing.
bool goal_met(const Figure& figure) {
  const double middle = median(figure.values);
  return figure.valid && (figure.more_is_better ? middle >= figure.goal : middle <= figure.goal);
}

Row row_of(const Figure& figure, const Outcome& outcome, const Options& options) {
  const auto [low, high] = std::ranges::minmax(figure.values);
  Row row;
  if (figure.run >= 0) row = outcome.runs.at(static_cast<std::size_t>(figure.run));
  row.what = kFigure;
  row.method = figure.what;
  row.seconds = {};
  row.value = median(figure.values);
  row.unit = figure.unit;
  row.found = format("%s%.4g (worst %.4g)", figure.at_least ? "> " : "", *row.value,
                     figure.more_is_better ? low : high);
  // Goals are those of full size: quick runs are not held to them.
  row.expected = options.quick ? "" : format("%g", figure.goal);
  if (!options.quick) row.passed = goal_met(figure);
  return row;
}

void run_case(const Case& one, const Options& options, std::vector<Row>& rows) {
  const Outcome outcome = one.run(options);
  for (const Row& run : outcome.runs) rows.push_back(run);
  for (const Figure& figure : outcome.figures)
    if (!figure.values.empty()) rows.push_back(row_of(figure, outcome, options));
  for (const std::string& note : outcome.notes) rows.push_back({.what = kNote, .found = note});
}

}  // namespace

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"intact", "a network of 5000 grains without forces takes up its weight, solved cold",
       intact_network},
      {"chain", "the first step of a hanging chain of 1000 disks, to 1e-9", hanging_chain},
      {"cantilever", "the first step of a clamped beam of 31 disks, to 1e-9", cantilever},
      {"growth", "cost of the first step of fresh deposits of 1000 to 100 000 grains", growth},
      {"factors", "one factorisation and solution against Eigen's, on a standing network",
       factorisation},
      {"deposition", "5000 grains deposited one a step of 1e-2, mean from empty to full",
       deposition},
      {"rest", "2000 steps of the packing at rest", rest},
      {"ploughing", "200 steps with the intruder half-way down, pressed with F_c", plough},
      {"piston", "the packing crushed by a piston to a coordination number of 3.2", piston}};
  return all;
}

std::vector<Task> goal_tasks(const Options& options) {
  return tasks_of(cases(), options, run_case);
}

void report_goals(std::span<const Row> rows, const Options& options, Section& section) {
  section.add(Paragraph{
      std::string("CPU time of one core, medians. Residuals and errors are those of the last "
                  "measurement; velocity errors are the worst of a disk.") +
      (options.quick ? " Goals hold for full size, so this quick run is not held to them." : "")});
  Table table{.columns = {{"case"},
                          {"figure"},
                          {"goal", true},
                          {"ours", true},
                          {"unit"},
                          {"factorisations a step", true},
                          {"residual", true},
                          {"velocity error (g dt)", true}}};
  BulletList notes;
  for (const Row& row : rows) {
    if (row.what == kNote) notes.items.push_back(row.name + ": " + row.found);
    if (row.what != kFigure) continue;
    const auto steps = static_cast<double>(std::max<std::int64_t>(1, row.steps));
    const Cell::Mark mark = !row.passed   ? Cell::Mark::none
                            : *row.passed ? Cell::Mark::inside
                                          : Cell::Mark::outside;
    table.rows.push_back({{row.name},
                          {row.method},
                          {row.expected},
                          {row.found, mark},
                          {row.unit},
                          {format("%.2f", static_cast<double>(row.factorisations) / steps)},
                          {format("%.1e", row.residual)},
                          {row.error ? format("%.1e", *row.error) : "-"}});
  }
  section.add(std::move(table));
  section.add(std::move(notes));
}

}  // namespace quicksand::bench
