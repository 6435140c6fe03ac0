// How many bodies a scene comes to hold, and the memory that they take.
#pragma once

#include <cstdint>

#include "core/scene/scenario.h"

namespace quicksand {

struct SceneSize {
  std::int64_t listed = 0;
  std::int64_t deposited = 0;  // expected, where a height ends the deposit
  std::int64_t pushed_in = 0;
  std::int64_t bodies() const { return listed + deposited + pushed_in; }
};

// Without the bodies of a state to start from.
SceneSize size_of(const Scenario& scenario);

// Of a run of a loose packing: the world, the scratch of its solver, a picture, and a state that is written. A dense
// one needs more, as the solver finds when it gets there (NotEnoughMemory). [bytes]
double bytes_to_compute(std::int64_t bodies);

}  // namespace quicksand
