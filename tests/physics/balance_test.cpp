// Momentum and energy of whole scenes.
#include <numeric>

#include "core/base/random.h"
#include "core/measures/measures.h"
#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Momentum);
QUICKSAND_PER_SOLVER(Energy);

double total_mass(const World& world) {
  return std::accumulate(world.disks.mass.begin(), world.disks.mass.end(), 0.0);
}

// Without gravity and walls: disks thrown at each other.
Scenario collapsing_cloud(Method method, const ContactLaw& law) {
  Scenario scene = falling_cluster(method, 16, 5, law);
  scene.solver.tolerance = 1e-6;  // momentum does not wait for convergence
  scene.box.floor = false;
  scene.gravity.reset();
  for (Disk& disk : scene.disks) disk.velocity -= disk.position - Vec2(1.8, 2.4);
  return scene;
}

Vec3 linear_and_angular_momentum(const World& world) {
  const Disks& d = world.disks;
  Vec3 sum(0, 0, 0);
  for (int i = 0; i < d.size(); ++i) {
    sum.head<2>() += d.mass[i] * d.velocity[i].head<2>();
    sum.z() += d.inertia(i) * d.velocity[i].z() +
               d.mass[i] * perpendicular(d.position[i]).dot(d.velocity[i].head<2>());
  }
  return sum;
}

TEST_P(Momentum, OfAnIsolatedCloudIsConserved) {
  Simulation run(collapsing_cloud(GetParam(), paper_law(50)));
  run.world.bonding = true;
  const Vec3 before = linear_and_angular_momentum(run.world);
  EXPECT_LE(distance(before.head<2>(), momentum(run.world)), tolerance::rounding(100));
  run.run_for(2);
  ASSERT_GT(run.bonds_formed, 10) << "they must meet";
  EXPECT_LE(distance(momentum(run.world), before.head<2>()), tolerance::rounding(1e3));
}

// The arms of a contact end on the surfaces, so that a gap that closes within the step carries a moment
// of first order in dt.
TEST_P(Momentum, AngularMomentumOfAnIsolatedCloudIsConservedToFirstOrder) {
  for (double dt : {1e-2, 1e-3}) {
    Scenario scene = collapsing_cloud(GetParam(), paper_law());
    scene.step.dt = dt;
    Simulation run(scene);
    const double before = linear_and_angular_momentum(run.world).z();
    run.run_for(1);
    EXPECT_NEAR(linear_and_angular_momentum(run.world).z(), before, tolerance::sampled(2 * dt));
  }
}

TEST_P(Momentum, FloorAndSideWallsCarryTheWeightOfAHeapAtRest) {
  Scenario scene = falling_cluster(GetParam(), 9, 2, paper_law());
  scene.solver.tolerance = 1e-7;
  scene.box = {.width = 4, .height = 5, .sides = Sides::walls, .floor = true};
  for (Disk& disk : scene.disks) disk.position.x() += 0.7;
  Simulation run(scene);
  run.run_for(5);
  ASSERT_LT(measure(run.world).max_speed, 1e-3) << "not yet at rest";
  Vec2 on_walls(0, 0);
  for (int k = 0; k < 3; ++k) on_walls += contact_force_on(run.world, wall_body(k));
  EXPECT_LE(distance(on_walls, Vec2(0, -total_mass(run.world))), tolerance::discretised(10));
}

// In every single step, at rest or not: the change of momentum is the impulse of gravity and floor.
TEST_P(Momentum, ChangesByTheImpulsesOfGravityAndFloor) {
  Scenario scene = falling_cluster(GetParam(), 12, 3, paper_law(20));
  scene.solver.tolerance = 1e-6;
  Simulation run(scene);
  run.world.bonding = true;
  for (int k = 0; k < 200; ++k) {
    const Vec2 before = momentum(run.world);
    run.advance();
    const Vec2 force = (momentum(run.world) - before) / run.step.dt;
    const Vec2 expected =
        Vec2(0, -total_mass(run.world)) - contact_force_on(run.world, wall_body(0));
    ASSERT_LE(distance(force, expected), tolerance::rounding(1e4)) << "in step " << k;
  }
}

TEST_P(Energy, NeverGrowsInAPassiveSystem) {
  for (double cohesion : {0.0, 100.0}) {
    for (std::uint64_t seed : {1, 2, 3}) {
      Scenario scene = falling_cluster(GetParam(), 16, seed, paper_law(cohesion));
      scene.solver.tolerance = 1e-8;
      Simulation run(scene);
      run.world.bonding = true;
      double before = mechanical_energy(run.world);
      for (int k = 0; k < 400; ++k) {
        run.advance();
        const double now = mechanical_energy(run.world);
        if (run.last.converged) {
          ASSERT_LE(now, before + tolerance::solved()) << "step " << k << ", cohesion " << cohesion;
        }
        before = now;
      }
      // One method alone stalls now and then; the fallback chain may not.
      if (GetParam() == Method::automatic) {
        EXPECT_EQ(run.unconverged, 0);
      }
    }
  }
}

TEST_P(Energy, APerfectlyInelasticImpactKeepsOnlyTheMotionOfTheCentre) {
  Scenario scene = empty_scene(GetParam());
  scene.disks = {{.velocity = {1, 0}}, {.position = {1.5, 0}, .radius = 0.5, .density = 3}};
  Simulation run(scene);
  run.run_for(1);
  EXPECT_NEAR(run.world.disks.velocity[0].x(), 0.25, tolerance::solved());
  EXPECT_NEAR(energies(run.world).kinetic, 0.125, tolerance::solved());
}

// Friction with the floor has no moment about the line of contact.
TEST_P(Energy, ASpinningDiskStartsToRollWithItsAngularMomentum) {
  Scenario scene = empty_scene(GetParam());
  scene.box.floor = true;
  scene.gravity = Vec2(0, -1);
  scene.grain_law.friction = 0.3;
  scene.disks = {{.position = {0, 0.5}, .spin = -6}};
  Simulation run(scene);
  run.run_for(10);
  // I w = (I + m r^2) w', I = m r^2/2.
  EXPECT_NEAR(run.world.disks.velocity[0].z(), -2, tolerance::solved(10));
  EXPECT_NEAR(run.world.disks.velocity[0].x(), 1, tolerance::solved(10));
}

}  // namespace
}  // namespace quicksand
