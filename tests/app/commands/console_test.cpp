// Frames of a panel that compute: what happens if a phase is refused in the middle of one.
#include "app/commands/console.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

// A vane finds no room after two steps.
TEST(Console, ARefusedPhaseStopsComputingAndItsStepsAreCounted) {
  const TemporaryFolder folder;
  Console console({folder.path(), folder.path()});
  std::vector<std::int64_t> steps;
  console.computed = [&](std::int64_t n) { steps.push_back(n); };
  console.perform(Json::parse(R"({"command": "load", "scene": {"name": "refused", "gravity": {},
    "box": {"width": 8, "height": 8}, "contact": {"friction": 0.3},
    "bodies": [{"position": [4, 0.5]}, {"position": [4, 1.5]}, {"position": [4, 2.5]},
               {"position": [4, 3.5]}], "step": {"dt": 1e-3},
    "phases": [{"type": "settle", "max_time": 2e-3, "until_rest": false},
               {"type": "vane", "shape": {"radius": 1.2}, "depth": 2, "torque": 5}]}})"));
  console.perform({{"command", "pace"}, {"steps_per_frame", 50}});
  console.perform({{"command", "start"}});
  for (int frame = 0; frame < 3; ++frame) console.panel_frame({}, 600, 400);
  EXPECT_FALSE(console.session().running) << "the refusal would be told in each frame";
  EXPECT_EQ(steps, std::vector<std::int64_t>{2});
}

}  // namespace
}  // namespace quicksand::test
