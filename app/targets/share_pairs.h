// Remaining against active share after pushes: whatever the forces were, the paper's pairs lie on the line of ours or not.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/plot/plot.h"
#include "app/targets/paper_targets.h"

namespace quicksand {

// The paper's pushes: as ids of its targets name their force, and as a reader does.
inline const std::vector<std::pair<std::string, std::string>> kPaperPushes{
    {"0.33", "0.33"}, {"1.0", "1"}, {"strong", "strong"}};

// The id of what the paper gives after its push with a force "0.33", "1.0" or "strong".
std::string push_target(const std::string& force, const std::string& quantity);

// With the paper's pairs and their forces; ours are to be put before them.
Plot share_pairs(const PaperTargets& targets, std::string name);

}  // namespace quicksand
