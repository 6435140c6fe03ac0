// The section on work against precision: how the references agree, times to residuals, and a plot of
// time against velocity error for each problem.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/bench/bench.h"
#include "app/plot/report_text.h"

namespace quicksand::bench {

namespace {

constexpr std::array kMethods{"auto", "interior_point", "gauss_seidel"};
// In the legend of plots, in the same order.
constexpr std::array kMethodNames{"solver chain", "interior point", "Gauss-Seidel"};
constexpr double kLeastError = 1e-16;  // what rounding leaves; smaller ones are drawn here [g dt]
constexpr double kTight = 1e-9;        // residual of a reference that can be relied on
constexpr double kAgreement =
    0.1;  // distance of the references below which velocities are unique [g dt]

struct Problem {
  const Row* reference = nullptr;
  std::vector<const Row*> rows;  // of all methods

  bool known() const { return reference->residual <= kTight && *reference->error <= kAgreement; }
  // No error can be told from less than the references' distance.
  double error(const Row& row) const { return std::max(*row.error, *reference->error); }
  const Row* at(const std::string& method, double tolerance) const {
    for (const Row* row : rows)
      if (row->method == method && row->what == "to residual" &&
          std::abs(std::log10(row->tolerance / tolerance)) < 0.5)
        return row;
    return nullptr;
  }
  // The last one of the method.
  const Row* best(const std::string& method) const {
    const Row* best = nullptr;
    for (const Row* row : rows)
      if (row->method == method && (best == nullptr || row->residual < best->residual)) best = row;
    return best;
  }
};

std::vector<Problem> problems_of(std::span<const Row> rows) {
  std::vector<Problem> all;
  for (const Row& row : rows) {
    if (row.what == "reference") all.push_back({.reference = &row});
    if ((row.what == "to residual" || row.what == "floor") && !all.empty())
      all.back().rows.push_back(&row);
  }
  return all;
}

Table reference_table(const std::vector<Problem>& problems) {
  Table table{.caption =
                  "The problems and their references. Velocities count as unique where both "
                  "references have a residual of 1e-9 or less and agree within 0.1 g dt.",
              .columns = {{"problem"},
                          {"what it is"},
                          {"disks", true},
                          {"contacts", true},
                          {"residual", true},
                          {"two references differ (g dt)", true},
                          {"velocities"}}};
  for (const Problem& p : problems)
    table.rows.push_back({{p.reference->name},
                          {p.reference->found},
                          {std::to_string(p.reference->size)},
                          {std::to_string(p.reference->contacts)},
                          {format("%.1e", p.reference->residual)},
                          {format("%.1e", *p.reference->error)},
                          {p.known() ? "unique" : "not unique, or not known"}});
  return table;
}

std::string time_at(const Problem& problem, const char* method, double tolerance) {
  const Row* row = problem.at(method, tolerance);
  if (row == nullptr) return "-";
  const std::string time = format("%.3g", 1e3 * row->seconds.cpu);
  return problem.known() ? time + format(" (%.0e)", problem.error(*row)) : time;
}

Table time_table(const std::vector<Problem>& problems) {
  Table table{
      .caption =
          "Milliseconds to a residual, and in brackets the velocity error there (g dt). Direct "
          "methods must also leave less than d_c/10 of gap error at bonds to be accepted. -: not "
          "reached; the last column says how far a method came, and the time it took.",
      .columns = {{"problem"},
                  {"method"},
                  {"1e-2", true},
                  {"1e-4", true},
                  {"1e-6", true},
                  {"1e-8", true},
                  {"1e-10", true},
                  {"1e-12", true},
                  {"smallest residual", true}}};
  for (const Problem& p : problems) {
    for (const char* method : kMethods) {
      const Row* best = p.best(method);
      if (best == nullptr) continue;
      std::vector<Cell> cells{{method == kMethods.front() ? p.reference->name : ""}, {method}};
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
        cells.push_back({time_at(p, method, tolerance)});
      cells.push_back({format("%.1e in %.3g ms", best->residual, 1e3 * best->seconds.cpu)});
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

// Error and time of each measurement of a method, by error and then by time.
Curve measurements(const Problem& problem, std::size_t method) {
  std::vector<std::pair<double, double>> points;
  for (const Row* row : problem.rows)
    if (row->method == kMethods[method])
      points.emplace_back(std::max(kLeastError, problem.error(*row)), 1e3 * row->seconds.cpu);
  std::ranges::sort(points);
  Curve curve{.name = kMethodNames[method]};
  for (const auto& [error, time] : points) {
    curve.x.push_back(error);
    curve.y.push_back(time);
  }
  return curve;
}

// The least time that gives an error at most this large.
Curve frontier(const Curve& measured) {
  Curve curve{.kind = Curve::Kind::steps, .role = Curve::Role::fit};
  for (std::size_t i = 0; i < measured.x.size(); ++i) {
    if (!curve.y.empty() && measured.y[i] >= curve.y.back()) continue;
    curve.x.push_back(measured.x[i]);
    curve.y.push_back(measured.y[i]);
  }
  // It holds for all larger errors, too.
  if (!curve.x.empty() && curve.x.back() < measured.x.back()) {
    curve.x.push_back(measured.x.back());
    curve.y.push_back(curve.y.back());
  }
  return curve;
}

Plot error_plot(const Problem& problem) {
  Plot plot{
      .name = "precision_" + file_name_text(problem.reference->name),
      .title = problem.reference->name + ", " + std::to_string(problem.reference->size) + " disks",
      .x = {.label = "velocity error, worst of a disk", .unit = "g dt", .logarithmic = true},
      .y = {.label = "CPU time", .unit = "ms", .logarithmic = true}};
  for (std::size_t method = 0; method < kMethods.size(); ++method) {
    Curve measured = measurements(problem, method);
    Curve least = frontier(measured);
    plot.curves.push_back(std::move(measured));
    plot.curves.push_back(std::move(least));
  }
  plot.references.push_back(
      {.name = "free fall", .low = 1, .of_x = true, .role = quicksand::Reference::Role::guide});
  return plot;
}

std::string figure_caption(const Problem& problem) {
  const Row& reference = *problem.reference;
  std::string caption = reference.name + ": " + reference.found + ".";
  if (*reference.error > kLeastError)
    caption += format(" Its references differ by %.1e g dt.", *reference.error);
  return caption;
}

}  // namespace

void report_precision(std::span<const Row> rows, const Options&, Section& section) {
  const std::vector<Problem> problems = problems_of(rows);
  section.add(
      Paragraph{"All solvers get the same contact problems, each that of one time step of a stored "
                "state, with the same first guess. Times include the ordering and the symbolic "
                "factorisation. Direct methods are run to each tolerance anew (median of at least "
                "three); Gauss-Seidel is one sequence of sweeps, its error noted as it passes each "
                "residual, up to a largest number of sweeps."});
  section.add(
      Paragraph{"There are two references for each problem. The first is auto at a tolerance of "
                "1e-12 from the warm start. The second is auto from twice the cohesion impulses, "
                "so by the interior point from afar, and then up to 40 iterations of Newton's "
                "method on the contact status (open, sticking, sliding, rolling). The one of "
                "smaller residual is taken, and no error below their distance is reported."});
  section.add(reference_table(problems));
  section.add(time_table(problems));
  section.add(Paragraph{
      "The figures show the problems whose velocities are unique. A point is a measurement at one "
      "of the residuals 1e-2 to 1e-12, or as far as a method comes; a line is the least time that "
      "gives an error at most this large. Further left and lower is better. Errors below 1e-16 g "
      "dt are drawn at 1e-16. Grey line: as wrong as free fall."});
  for (const Problem& problem : problems) {
    if (!problem.known() || problem.rows.empty()) continue;
    section.add(quicksand::Figure{error_plot(problem), figure_caption(problem)});
  }
}

}  // namespace quicksand::bench
