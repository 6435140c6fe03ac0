// A scene for tests of states: grains that stick, some through the periodic sides, and are pierced by an
// intruder; without the push there is none.
#pragma once

namespace quicksand::test {

inline constexpr const char* kPiercedScene = R"({
  "name": "pierced", "seed": 5, "gravity": {},
  "box": {"width": 12, "height": 8},
  "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
  "step": {"dt": 0.01},
  "phases": [
    {"type": "deposit", "grains": 40, "interval": 0},
    {"type": "push", "diameter": 2, "force": 300, "max_time": 0.2, "sample_every": 0.05}]
})";

}  // namespace quicksand::test
