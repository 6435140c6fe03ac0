// Validation of a run that went through to its end.
#pragma once

#include <string>

#include "core/measures/measures.h"
#include "core/protocol/protocol.h"
#include "core/scene/scenario.h"

namespace quicksand {

struct StrictBounds {
  double max_overlap = 0.01;  // [d]
};

// The worst overlap of a run that stands here [d].
double worst_overlap(const ProtocolState& state, double present_overlap);

// What the steps of a run by NSCD are, in a sentence: a method that does not converge by design. Empty for other runs.
std::string nscd_note(const Scenario& scenario, const ProtocolState& state, std::int64_t steps);

// Why validation of the run failed, in a sentence; empty if nothing is wrong. `now`: the bodies as they are at present.
std::string validation_failures(const ProtocolState& state, const Sample& now,
                                const StrictBounds& bounds);

}  // namespace quicksand
