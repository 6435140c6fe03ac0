// When the bonds fail: while the intruder goes down, or after it has passed, when its channel falls in.
#pragma once

#include "app/paper/paper_results.h"

namespace quicksand {

// A table of bonds and contacts with the intruder half-way down, at the floor, with the channel half filled, and at
// rest, and a plot of the active share over time. `height`: of the box [d]; `all`: realizations that there should be.
void add_push_course(Section& section, const PaperResults& results, const PushCurve& curve,
                     double height, int all);

}  // namespace quicksand
