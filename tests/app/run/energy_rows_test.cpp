// Every sample of a run accounts for its energy.
#include <gtest/gtest.h>

#include "app/json/json_text.h"
#include "app/scene_json/scenario_json.h"
#include "app/series/sampled_run.h"
#include "core/scene/make_world.h"

namespace quicksand::test {
namespace {

// Gravity counts among the external forces, so what is neither dissipated nor gained is kinetic.
TEST(EnergyOfRows, WhatIsNotDissipatedMoves) {
  const Scenario scene = scenario_from_json(parse_json(R"({
    "name": "fall", "gravity": {}, "box": {"width": 6, "height": 9, "sides": "walls"},
    "contact": {"friction": 0.3, "rolling_friction": 0.1}, "step": {"dt": 0.01},
    "bodies": [{"position": [2, 1], "velocity": [1, 0], "spin": 3}, {"position": [3.2, 2]},
               {"position": [2.4, 3], "velocity": [-1, 0]}, {"position": [4, 4], "spin": -2}],
    "phases": [{"type": "settle", "max_time": 4}]})"));
  std::vector<Row> rows;
  SampledRun run(scene, {.world = make_world(scene)}, 0.1,
                 [&](const Row& row, const World&) { rows.push_back(row); });
  while (run.advance() == Progress::running) {
  }
  ASSERT_GT(rows.size(), 20U);
  const auto kinetic = [](const Row& row) {
    return row.sample.energy.kinetic + row.sample.energy.rotational;
  };
  EXPECT_EQ(rows.front().energy_dissipated, 0);
  EXPECT_GT(rows.back().energy_dissipated, 1);
  constexpr double kRounding = 1e-10;
  for (const Row& row : rows)
    EXPECT_NEAR(
        kinetic(row),
        kinetic(rows.front()) + row.external_work - row.energy_dissipated + row.energy_gained,
        kRounding)
        << "at " << row.sample.time;
}

}  // namespace
}  // namespace quicksand::test
