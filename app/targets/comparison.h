// The comparison of measurements with the paper: a verdict on each, and the table of all.
//
// Inside: within the paper's interval, or within half a unit of the last digit that it prints, widened by two
// standard errors of the measurement. Of a single realization the error is unknown, and nothing is added.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/plot/plot.h"
#include "app/report/report.h"
#include "app/targets/evidence.h"
#include "app/targets/paper_targets.h"
#include "core/base/types.h"

namespace quicksand {

struct Measured {
  double value = 0;                        // mean over realizations [unit of the target]
  std::optional<double> standard_error{};  // of the mean; absent where it is unknown
  int n = 1;                               // realizations, or what the target counts
  std::string note{};                      // what was different, what could be seen
  std::filesystem::path report{};          // that it is from; empty: the one that shows it
  std::optional<Vec2> lower_box{};         // that it is of, where that of the table is higher [d]
};

// "51 x 199 d".
std::string box_text(const Vec2& size);

// Mean, standard error and number of the values; there must be one.
Measured measured_over(std::span<const double> values, std::string note = {});
// Absent if there are none.
std::optional<Measured> mean_over(std::span<const double> values, const std::string& note = {});

// With its error bar, if there is one to add.
void add_point(Curve& curve, double x, const std::optional<Measured>& y);

// By id of the target in assets/paper/targets.json.
using Findings = std::map<std::string, Measured>;

// "0.372 ± 0.004 (10)", "-" if absent; the number of runs is left out where it is `all`.
Cell cell_of(const std::optional<Measured>& measured, int all);

struct MethodFindings {
  std::string method;  // "nscd", "exact"
  Findings findings;
};
// As it stands in a table: "NSCD".
std::string method_title(const std::string& method);
// In plots, by its title: NSCD blue, exact steps vermilion.
Colour method_colour(const std::string& title);

struct Verdict {
  bool inside = false;
  bool by_error = false;  // inside only because ours is off by at most two standard errors
  // Neither inside nor outside: inside only by its error, and that is more than a quarter of the paper's number.
  bool undecided = false;
  double deviation = 0;  // from the nearest value that the paper admits, 0 there [unit]
};
Verdict verdict_on(const Target& target, const Measured& measured);

// "0.68", "0.40 to 0.43", "almost the bottom (read as at least 0.9)".
std::string paper_text(const Target& target);

// A row a target: experiment, paper, each method's number, what is inside, and for what is outside the measured reason,
// or that there is none. A number that is from another report links to it. Links are as seen from the folder of the
// report.
Table comparison_table(const PaperTargets& targets, const std::vector<MethodFindings>& methods,
                       const Evidence& evidence, const std::filesystem::path& report);

// How each number of the paper is read, and what was measured for it.
Table reading_table(const PaperTargets& targets, const std::vector<MethodFindings>& methods);

struct Tally {
  int inside = 0, outside = 0, undecided = 0, not_measured = 0;
};
// Throws InputError if something measured is no target.
Tally tally(const PaperTargets& targets, const Findings& findings);

}  // namespace quicksand
