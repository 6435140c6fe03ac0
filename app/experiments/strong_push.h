// Which push stands for the paper's strong one, whose force it does not give, and its pairs of shares beside ours.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/paper/paper_results.h"

namespace quicksand {

// What the paper gives after its push with a force "0.33", "1.0" or "strong".
Target paper_push(const std::string& force, const std::string& quantity);

struct StrongPush {
  std::size_t index = 0;  // in the curve
  std::string note{};     // its force, and among which it was chosen
};

// Of the forces beyond F_c that after which the active share is nearest to the paper's. Absent if none has a share.
std::optional<StrongPush> strong_push(const PaperResults& results, const PushCurve& curve);

// Remaining against active share: whatever the forces, the paper's pairs lie on the curve of ours or not.
void add_share_pairs(Section& section, const PaperResults& results, const PushCurve& curve);

}  // namespace quicksand
