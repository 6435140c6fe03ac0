// Shear strength over depth, pooled over the grains of all realizations.
#pragma once

#include <optional>
#include <vector>

#include "app/paper/paper_results.h"
#include "core/measures/linear_fit.h"

namespace quicksand {

struct PaperStrength {
  std::vector<double> depth;     // below the top (n) [d]
  std::vector<double> strength;  // mean (n) [F_g]
  std::vector<double> error;     // of the mean (n) [F_g]; 0 for a single grain
  int grains = 0;                // with a critical force
  int unbracketed = 0;           // of these, whose lower end only ran out of time (is_bracketed)
  int never_moved = 0;           // without
  std::optional<Line> against_depth;   // [F_g/d], [F_g]
  std::optional<Line> against_weight;  // slope: the effective friction coefficient [1]

  // Of the line at the mean depth of all grains, which is their mean strength, and that depth; absent without grains.
  std::optional<Mean> level;  // [F_g]
  double level_depth = 0;     // [d]

  // The line at one depth over that at another; needs a line. [1]
  Mean line_ratio(double at, double other) const;

  // Greatest depth down to which all strengths agree with their weighted mean within two standard errors;
  // absent unless there are two depths, each with an error. [d]
  std::optional<double> constant_down_to() const;
};

// Of two independent values. [1]
Mean quotient(const Mean& over, const Mean& under);

// Of the shear runs of a group; empty vectors if none has finished.
PaperStrength paper_strength(const PaperResults& results, const RunGroup& shears);

// Adds points with bars of one standard error, and the straight line through all grains, from the first depth to the
// last.
void add_strength(Plot& plot, const PaperStrength& strength, const std::string& name,
                  double x_scale = 1, double y_scale = 1);

// The groups of shear runs that the figures on strength share.
struct StrengthRuns {
  RunGroup loose;         // unperturbed
  RunGroup weak, strong;  // the same made with a hundredth and a hundredfold cohesion force
  RunGroup compact, compact_rough;  // perturbed by the piston, friction 0.3 and 0.6
};
StrengthRuns plan_strength(PaperJobs& jobs);

}  // namespace quicksand
