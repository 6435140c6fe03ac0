// Tables of what groups of runs end with.
#pragma once

#include <string>
#include <vector>

#include "app/paper/paper_results.h"

namespace quicksand {

struct OutcomeRow {
  std::string text;
  RunGroup runs;
};

// A row a group, with depth, shares of bonds and coordination number at the end of its pushes. `all`: realizations
// that there should be.
Table push_outcomes(const PaperResults& results, const std::string& caption,
                    const std::vector<OutcomeRow>& rows, int all);
// The same after the piston, with the volume fraction in place of the depth.
Table piston_outcomes(const PaperResults& results, const std::string& caption,
                      const std::vector<OutcomeRow>& rows, int all);

}  // namespace quicksand
