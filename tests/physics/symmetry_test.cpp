// The answer does not depend on the frame, the order of the bodies or the name of a direction.
#include <algorithm>
#include <cmath>

#include "core/problem/solver_settings.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Symmetry);

// Long enough for many contacts, short enough that rounding has not grown to a different history.
constexpr int kSteps = 60;

// A cluster that hits the floor, with friction, rolling friction and bonds.
Scenario scene_of(Method method) {
  Scenario scene = falling_cluster(method, 12, 4, paper_law(30));
  scene.initial_bonds = InitialBonds::touching;
  return scene;
}

Simulation run_of(const Scenario& scene) {
  Simulation run(scene);
  run.world.bonding = true;
  run.advance(kSteps);
  EXPECT_EQ(run.unconverged, 0);
  EXPECT_GT(run.bonds_formed, 5);
  return run;
}

// Worst difference of positions and velocities after mapping those of `a`.
template <class Map>
double difference(const Simulation& a, const Simulation& b, Map map) {
  double worst = 0;
  for (int i = 0; i < a.world.disks.size(); ++i) {
    Vec2 position = a.world.disks.position[i];
    Vec3 velocity = a.world.disks.velocity[i];
    map(position, velocity);
    worst = std::max({worst, distance(position, b.world.disks.position[i]),
                      distance(velocity, b.world.disks.velocity[i])});
  }
  return worst;
}

TEST_P(Symmetry, RotatingTheSceneRotatesTheAnswer) {
  const Scenario scene = scene_of(GetParam());
  const Simulation straight = run_of(scene);
  for (double angle : {0.3, 1.5, 2.9, -2.0}) {
    const Simulation turned = run_of(rotated(scene, angle));
    const double c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](auto v) { return Vec2(c * v.x() - s * v.y(), s * v.x() + c * v.y()); };
    EXPECT_LE(difference(straight, turned,
                         [&](Vec2& x, Vec3& v) {
                           x = turn(x);
                           v.head<2>() = turn(Vec2(v.head<2>()));
                         }),
              tolerance::solved())
        << angle;
  }
}

TEST_P(Symmetry, MirroringTheSceneMirrorsTheAnswer) {
  const Scenario scene = scene_of(GetParam());
  EXPECT_LE(difference(run_of(scene), run_of(mirrored(scene)),
                       [](Vec2& x, Vec3& v) {
                         x.x() = -x.x();
                         v.x() = -v.x(), v.z() = -v.z();
                       }),
            tolerance::solved());
}

TEST_P(Symmetry, TheOrderOfTheBodiesDoesNotChangeTheMotion) {
  const Scenario scene = scene_of(GetParam());
  Scenario reversed = scene;
  std::ranges::reverse(reversed.disks);
  Simulation there = run_of(reversed);
  std::ranges::reverse(there.world.disks.position);
  std::ranges::reverse(there.world.disks.velocity);
  EXPECT_LE(difference(run_of(scene), there, [](Vec2&, Vec3&) {}), tolerance::solved());
}

TEST_P(Symmetry, AMovingFrameSeesTheSameMotion) {
  const Vec2 boost(3, -2);
  Scenario scene = scene_of(GetParam());
  scene.box.floor = false;
  scene.walls.push_back({});
  Scenario moving = scene;
  moving.walls[0].velocity = boost;
  for (Disk& disk : moving.disks) disk.velocity += boost;
  const double t = kSteps * scene.step.dt;
  EXPECT_LE(difference(run_of(scene), run_of(moving),
                       [&](Vec2& x, Vec3& v) {
                         x += t * boost;
                         v.head<2>() += boost;
                       }),
            tolerance::solved());
}

TEST_P(Symmetry, ShiftingAPeriodicSceneShiftsTheAnswer) {
  Scenario scene = scene_of(GetParam());
  scene.box = {.width = 5.5, .height = 10, .sides = Sides::periodic, .floor = true};
  // Whole and broken widths: bodies lie inside, on and beyond the sides.
  for (double shift : {1.7, 5.5, -30.3}) {
    Scenario shifted = scene;
    for (Disk& disk : shifted.disks) disk.position.x() += shift;
    EXPECT_LE(difference(run_of(scene), run_of(shifted), [&](Vec2& x, Vec3&) { x.x() += shift; }),
              tolerance::solved())
        << shift;
  }
}

// Contacts through the sides are like any other: a row that closes on itself holds the pressure.
TEST_P(Symmetry, APeriodicRowUnderASidewaysForceMovesAsOne) {
  Scenario scene = empty_scene(GetParam());
  scene.box = {.width = 4, .height = 4, .sides = Sides::periodic, .floor = false};
  for (int k = 0; k < 4; ++k) scene.disks.push_back({.position = {0.25 + k, 1}});
  scene.disk_forces.assign(4, Vec3(0, 0, 0));
  scene.disk_forces[0].x() = 8;
  Simulation run(scene);
  run.run_for(1);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(run.world.disks.velocity[k].x(), 2, tolerance::solved()) << k;
}

}  // namespace
}  // namespace quicksand
