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
constexpr double kTight = 1e-9;  // residual of a reference that can be relied on
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

// For each method the time that first gives an error at most this large.
Curve frontier(const Problem& problem, const char* method) {
  Curve curve{.name = method, .kind = Curve::Kind::line_points};
  constexpr double kLeast = 1e-16;  // what rounding leaves
  for (const Row* row : problem.rows) {
    if (row->method != method) continue;
    curve.x.push_back(std::max(kLeast, problem.error(*row)));
    curve.y.push_back(1e3 * row->seconds.cpu);
  }
  return curve;
}

Plot error_plot(const Problem& problem) {
  Plot plot{
      .name = "precision_" + file_name_text(problem.reference->name),
      .title = problem.reference->name + ", " + std::to_string(problem.reference->size) + " disks",
      .x = {.label = "velocity error, worst of a disk", .unit = "g dt", .logarithmic = true},
      .y = {.label = "CPU time", .unit = "ms", .logarithmic = true}};
  for (const char* method : kMethods) plot.curves.push_back(frontier(problem, method));
  plot.references.push_back(
      {.name = "free fall", .low = 1, .of_x = true, .role = quicksand::Reference::Role::guide});
  return plot;
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
                "method on the modes of the contacts (open, stick, slide, roll). The one of "
                "smaller residual is taken, and no error below their distance is reported."});
  section.add(reference_table(problems));
  section.add(time_table(problems));
  for (const Problem& problem : problems) {
    if (!problem.known() || problem.rows.empty()) continue;
    section.add(quicksand::Figure{
        error_plot(problem),
        problem.reference->name + ": " + problem.reference->found +
            format(". Further left and lower is better; points from right to left are residuals "
                   "1e-2 to 1e-12, or as far as a method comes. Grey line: as wrong as free fall. "
                   "The references differ by %.1e g dt.",
                   *problem.reference->error)});
  }
}

}  // namespace quicksand::bench
