// All cases, in the order in which they are run.
#pragma once

#include <vector>

#include "app/bench/goals/goal_case.h"

namespace quicksand::bench {

const std::vector<Case>& cases();

Outcome intact_network(const Options& options);
Outcome rest(const Options& options);
Outcome deposition(const Options& options);
Outcome plough(const Options& options);
Outcome piston(const Options& options);
Outcome hanging_chain(const Options& options);
Outcome cantilever(const Options& options);
Outcome growth(const Options& options);
Outcome factorisation(const Options& options);

}  // namespace quicksand::bench
