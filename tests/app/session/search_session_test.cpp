// What a search finds is told where the session is watched.
#include <gtest/gtest.h>

#include "app/json/json_text.h"
#include "app/scene_json/scenario_json.h"
#include "app/session/session.h"
#include "core/base/format.h"

namespace quicksand::test {
namespace {

TEST(SessionSearch, TellsTheIntervalOfTheNewestCriticalForce) {
  Session session;
  session.load(scenario_from_json(parse_json(R"({"gravity": {}, "box": {"width": 8, "height": 8},
    "contact": {}, "bodies": [{"position": [4, 0.5], "role": "intruder"}],
    "phases": [{"type": "pull", "first_force": 0.7}]})")));
  EXPECT_EQ(session.newest_critical_force(), "");
  session.run({.phase_end = true});
  const CriticalForce& found = session.protocol().state().critical_forces.at(0);
  EXPECT_LE(found.force_low, 1) << "its weight";
  EXPECT_GE(found.force_high, 1);
  EXPECT_EQ(session.newest_critical_force(),
            format("%.4g to %.4g F_g", found.force_low, *found.force_high));
}

}  // namespace
}  // namespace quicksand::test
