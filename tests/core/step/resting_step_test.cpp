// Rest: what does not move is not computed again, and nobody can tell.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/step/step.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"

namespace quicksand {
namespace {

QUICKSAND_PER_GLOBAL_SOLVER(Rest);

// Takes a step, and the same with a stepper that knows nothing of the steps before.
StepReport advance(Stepper& stepper, World& world, const Scenario& scene) {
  World computed = world;
  const StepReport known = stepper.advance(world, scene.step, scene.solver);
  Stepper fresh;
  const StepReport report = fresh.advance(computed, scene.step, scene.solver);
  EXPECT_EQ(world_hash(world), world_hash(computed)) << "after step " << world.step;
  EXPECT_EQ(known.solve.residual.natural, report.solve.residual.natural);
  EXPECT_EQ(known.energy.work, report.energy.work);
  EXPECT_EQ(known.energy.change, report.energy.change);
  return known;
}

std::int64_t solutions(Stepper& stepper) { return stepper.clock().counts.solutions; }

// A chain whose links hold each other's weight over a lever is the hardest to bring to rest: errors add up along it.
TEST_P(Rest, IsComputedOnce) {
  for (const Scenario& scene :
       {column(GetParam(), 6), hanging_chain(GetParam(), 6, 20), cantilever(GetParam(), 5, 1e4)}) {
    World world = make_world(scene);
    Stepper stepper;
    for (int k = 0; k < 30; ++k) advance(stepper, world, scene);
    const std::int64_t before = solutions(stepper);
    const World still = world;
    for (int k = 0; k < 30; ++k) {
      const StepReport report = advance(stepper, world, scene);
      EXPECT_EQ(report.energy.work, 0);
      EXPECT_EQ(report.solve.iterations, 0);
    }
    EXPECT_EQ(solutions(stepper), before);
    EXPECT_TRUE(same_but_for_time(world, still));
    EXPECT_EQ(world.step, still.step + 30);
    EXPECT_NEAR(world.time, still.time + 30 * scene.step.dt, 1e-12);
  }
}

// A branch that turns about its root by so little that the start is within the error there, and its end is not.
TEST(RestBegins, InALongBranchThatSways) {
  Scenario scene = cantilever(Method::automatic, 30, 1e6);
  scene.solver = {};
  World world = make_world(scene);
  Stepper stepper;
  for (int k = 0; k < 20; ++k) stepper.advance(world, scene.step, scene.solver);
  const double error = 1e-5 * scene.solver.tolerance * 1e6 * scene.step.dt;
  const double spin = 0.3 * error;
  for (int i = 1; i < world.disks.size(); ++i)
    world.disks.velocity[i] = Vec3(0, spin * world.disks.position[i].x(), spin);
  ASSERT_GT(world.disks.velocity.back().y(), 5 * error);
  for (int k = 0; k < 10; ++k) stepper.advance(world, scene.step, scene.solver);
  const std::int64_t before = solutions(stepper);
  for (int k = 0; k < 10; ++k) stepper.advance(world, scene.step, scene.solver);
  EXPECT_EQ(solutions(stepper), before);
  for (const Vec3& v : world.disks.velocity) EXPECT_EQ(v, Vec3(0, 0, 0));
}

// Each of these changes what the next step does, which an untouched stepper must see.
TEST(RestEnds, WhenSomebodyActs) {
  const std::vector<std::function<void(World&, Scenario&)>> acts{
      [](World& world, Scenario&) { world.disks.applied[3] = Vec3(0, 100, 0); },
      [](World& world, Scenario&) { world.disks.velocity[3] = Vec3(0.1, 0, 0); },
      [](World& world, Scenario&) { world.gravity = Vec2(0.2, -1); },
      [](World& world, Scenario&) { world.gravity.reset(); },
      [](World& world, Scenario&) { world.grain_law.cohesion_force = 1; },
      [](World& world, Scenario&) { world.bonds.list[2].state = BondState::broken; },
      [](World& world, Scenario&) { world.disks.mass[5] *= 2, world.disks.inverse_mass[5] /= 2; },
      [](World& world, Scenario&) {
        world.walls.push_back({.point = {0, -9}, .normal = {0, 1}});
      },
      [](World&, Scenario& scene) { scene.step.dt /= 2; }};
  for (std::size_t k = 0; k < acts.size(); ++k) {
    Scenario scene = hanging_chain(Method::automatic, 6, 20);
    World world = make_world(scene);
    Stepper stepper;
    for (int step = 0; step < 20; ++step) advance(stepper, world, scene);
    const std::int64_t before = solutions(stepper);
    acts[k](world, scene);
    advance(stepper, world, scene);
    EXPECT_GT(solutions(stepper), before) << "act " << k;
  }
}

// However slow it is: at rest is only what is within the error of a solution.
TEST(RestEnds, NoMotion) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = {.friction = 0.3, .rolling_friction = 0.1, .cohesion_force = 1e4};
  scene.disks = {{.position = {0, 0}, .velocity = {1e-9, 0}}};
  World world = make_world(scene);
  Stepper stepper;
  for (int k = 0; k < 100; ++k) stepper.advance(world, scene.step, scene.solver);
  EXPECT_NEAR(world.disks.position[0].x(), 1e-9 * world.time, 1e-15);
}

// A force that is hardly too large for the bond moves its grain at the rate of the excess.
TEST(RestEnds, NoSlowBeginning) {
  const Scenario scene = pulled_pair(Method::automatic, 1e4 * (1 + 1e-9), 1e4);
  World world = make_world(scene);
  Stepper stepper;
  for (int k = 0; k < 10; ++k) stepper.advance(world, scene.step, scene.solver);
  const double excess = 1e-5;  // [F_g]
  EXPECT_NEAR(world.disks.velocity[1].x(), excess * world.time / world.disks.mass[1],
              0.01 * excess * world.time / world.disks.mass[1]);
}

}  // namespace
}  // namespace quicksand
