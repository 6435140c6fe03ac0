// What the walls bear is what the bodies weigh.
#include "core/forces/wall_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

TEST(WallLoads, TheFloorBearsTheWeightOfAColumn) {
  Simulation run(column(Method::automatic, 5));
  EXPECT_EQ(wall_loads(run.world).floor, 0) << "before any step";
  run.advance(3);
  const WallLoads loads = wall_loads(run.world);
  EXPECT_NEAR(loads.floor.value(), 5, tolerance::solved());
  EXPECT_FALSE(loads.side || loads.side_thrust || loads.piston) << "there are none";
}

// Two disks between smooth upright walls, the upper one on the lower at 45 degrees: the lower presses on the floor with both
// weights, and each on its wall with the upper one's.
TEST(WallLoads, DisksWedgedBetweenSmoothWallsPressOnThem) {
  const double c = std::numbers::sqrt2 / 2;
  Scenario scene = empty_scene(Method::automatic);
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 1 + c, .height = 4, .sides = Sides::walls, .floor = true};
  scene.disks = {{.position = {0.5, 0.5}}, {.position = {0.5 + c, 0.5 + c}}};
  Simulation run(scene);
  run.advance(3);
  const WallLoads loads = wall_loads(run.world);
  EXPECT_NEAR(loads.floor.value(), 2, tolerance::solved());
  EXPECT_NEAR(loads.side.value(), 0, tolerance::solved());
  EXPECT_NEAR(loads.side_thrust.value(), 2, tolerance::solved());
}

// Its normal says what it bears where its role does not.
TEST(WallLoads, ALidIsNoFloor) {
  Scenario scene = column(Method::automatic, 2);
  scene.walls = {{.point = {0, 2}, .normal = {0, -1}, .mass = 1, .force = 30}};
  Simulation run(scene);
  run.advance(3);
  const WallLoads loads = wall_loads(run.world);
  EXPECT_NEAR(loads.piston.value(), 1 + 30, tolerance::solved(30));
  EXPECT_NEAR(loads.floor.value(), 2 + 1 + 30, tolerance::solved(30));
}

// Janssen: by friction, upright walls bear a part of what lies between them.
TEST(WallLoads, FloorAndRoughSidesTogetherBearTheWeight) {
  Scenario scene = falling_cluster(Method::automatic, 25, 3, paper_law());
  for (Disk& disk : scene.disks) disk.position.x() += 0.6;
  scene.box = {.width = 6, .height = 20, .sides = Sides::walls, .floor = true};
  Simulation run(scene);
  run.run_for(30);
  double weight = 0;
  for (const double mass : run.world.disks.mass) weight += mass;
  const WallLoads loads = wall_loads(run.world);
  EXPECT_GT(loads.side.value(), 0);
  EXPECT_GT(loads.side_thrust.value(), loads.side.value() / 0.3 - tolerance::solved())
      << "friction bears no more than its coefficient allows";
  EXPECT_NEAR(loads.floor.value() + loads.side.value(), weight, tolerance::discretised(weight));
}

}  // namespace
}  // namespace quicksand
