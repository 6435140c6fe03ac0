// The comparison of a measurement with the paper: a verdict and its row in a table.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "app/report/report.h"
#include "app/targets/paper_targets.h"

namespace quicksand {

struct Measured {
  double value = 0;                        // mean over realizations [unit of the target]
  std::optional<double> standard_error{};  // of the mean; absent for a single one
  int n = 1;                               // realizations
  std::string note{};                      // for the table: what was different, what could be seen
};

// Mean, standard error and number of the values; there must be one.
Measured measured_over(std::span<const double> values, std::string note = {});

struct Verdict {
  bool inside = false;
  double deviation = 0;  // from the nearest value that the paper admits, 0 there [unit]
  double beyond = 0;     // past the tolerance, 0 if inside [unit]
  // The bound of the tolerance is nearer than two standard errors of at least three: more might turn it.
  bool close = false;
};
Verdict verdict_on(const Target& target, const Measured& measured);

// "0.68", "0.40 to 0.43", "at least 0.9 (almost the bottom)".
std::string paper_text(const Target& target);

// A row a target, in their order: quantity, paper, tolerance, ours, verdict, note, source. Those without a
// measurement are "not measured". Throws InputError if something measured is no target.
Table comparison_table(const PaperTargets& targets,
                       const std::map<std::string, Measured>& measured);

struct Tally {
  int inside = 0, outside = 0, not_measured = 0;
};
Tally tally(const PaperTargets& targets, const std::map<std::string, Measured>& measured);

}  // namespace quicksand
