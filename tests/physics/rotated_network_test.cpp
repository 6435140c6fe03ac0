// A bonded network and gravity turned together give the turned answer: no direction is special, and
// forces of a network are not left to where the solver happens to start.
#include <Eigen/Geometry>

#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/world/ballistic.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_GLOBAL_SOLVER(Network);

// A ballistic deposit of n grains, bonded where they touch, some of which are held.
Scenario deposit_in_the_air(Method method, int n, double cohesion) {
  Scenario soil = empty_scene(method);
  soil.box = {.width = 8, .height = 30, .sides = Sides::walls, .floor = true};
  World world = make_world(soil);
  for (int k = 0; k < n; ++k) {
    const double radius = 0.3 + 0.3 * world.random.uniform();
    const double x = radius + world.random.uniform() * (8 - 2 * radius);
    world.disks.add({.position = LandingSite(world).land(x, radius)->centre, .radius = radius});
  }
  Scenario scene = empty_scene(method);
  scene.gravity = Vec2(0, -1);
  scene.grain_law = paper_law(cohesion);
  scene.initial_bonds = InitialBonds::touching;
  for (int i = 0; i < n; ++i)
    scene.disks.push_back({.position = world.disks.position[i],
                           .radius = world.disks.radius[i],
                           .fixed = world.disks.position[i].y() < 0.7});
  return scene;
}

double worst_velocity_difference(const Simulation& straight, const Simulation& turned,
                                 double angle) {
  const Eigen::Rotation2Dd turn(angle);
  double worst = 0;
  for (int i = 0; i < straight.world.disks.size(); ++i) {
    Vec3 expected = straight.world.disks.velocity[i];
    expected.head<2>() = turn * Vec2(expected.head<2>());
    worst = std::max(worst, distance(expected, turned.world.disks.velocity[i]));
  }
  return worst;
}

double fastest(const Simulation& run) {
  double speed = 0;
  for (const Vec3& v : run.world.disks.velocity) speed = std::max(speed, v.norm());
  return speed;
}

// Loads the paper's bonds as a packing does; whatever is not held stays with what is.
TEST_P(Network, HoldsInAnyDirectionOfGravity) {
  const Scenario scene = deposit_in_the_air(GetParam(), 80, 1e4);
  for (double angle : {0.0, 0.4, 1.3, 2.2, -2.8}) {
    Simulation run(rotated(scene, angle));
    run.advance(10);
    EXPECT_EQ(run.unconverged, 0);
    EXPECT_EQ(run.bonds_broken, 0);
    EXPECT_LE(fastest(run), tolerance::solved()) << angle;
  }
}

// With weak bonds branches roll, slide and break off.
TEST_P(Network, ThatGivesWayMovesTheSameInAnyFrame) {
  const Scenario scene = deposit_in_the_air(GetParam(), 80, 20);
  Simulation straight(scene);
  straight.advance(20);
  ASSERT_GT(fastest(straight), 0.05) << "it shall move";
  for (double angle : {0.4, 1.3, 2.2, -2.8}) {
    Simulation turned(rotated(scene, angle));
    turned.advance(20);
    EXPECT_EQ(turned.unconverged, 0);
    EXPECT_EQ(turned.bonds_broken, straight.bonds_broken);
    EXPECT_LE(worst_velocity_difference(straight, turned, angle), tolerance::solved()) << angle;
  }
}

}  // namespace
}  // namespace quicksand
