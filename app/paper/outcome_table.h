// Tables of what groups of runs end with.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/paper/paper_results.h"

namespace quicksand {

struct OutcomeRow {
  std::string text;
  RunGroup runs;
};

struct FinalQuantity {
  const char* quantity;
  const char* title;  // of its column
};
inline constexpr FinalQuantity kAfterPush[] = {{"depth", "depth [d]"},
                                               {"active_bond_fraction", "active share"},
                                               {"remaining_bond_fraction", "remaining share"},
                                               {"coordination", "coordination number"}};
inline constexpr FinalQuantity kAfterPiston[] = {
    {"volume_fraction", "volume fraction"}, kAfterPush[1], kAfterPush[2], kAfterPush[3]};

// A row a group, its text in the column `first`, with the means of these quantities. `all`: realizations that there
// should be.
Table outcome_table(const PaperResults& results, const std::string& caption, const Column& first,
                    const std::vector<OutcomeRow>& rows, std::span<const FinalQuantity> of,
                    int all);

}  // namespace quicksand
