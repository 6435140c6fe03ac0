// Viscous drag against its closed forms.
#include "core/bodies/drag.h"

#include <cmath>

#include "core/scene/scenario.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(ViscousDrag);

Scenario falling_disk(Method method, const Drag& drag, double diameter = 1) {
  Scenario scene = empty_scene(method);
  scene.gravity = Vec2(0, -1);
  scene.drag = drag;
  scene.disks.push_back({.radius = diameter / 2});
  return scene;
}

double fall_speed(const Scenario& scene, double dt, double time) {
  Simulation run(scene);
  run.step.dt = dt;
  run.run_for(time);
  return -run.world.disks.velocity[0].y();
}

// m g = gamma D v with m = D^2, and m g = beta D^2 v^2.
TEST(Drag, LetsABodyFallAtItsTerminalVelocity) {
  for (const double diameter : {1.0, 0.5, 3.0}) {
    EXPECT_NEAR(fall_speed(falling_disk(Method::automatic, {.linear = 4}, diameter), 1e-2, 50),
                diameter / 4, tolerance::exact());
    EXPECT_NEAR(fall_speed(falling_disk(Method::automatic, {.quadratic = 4}, diameter), 1e-2, 50),
                0.5, tolerance::exact());
  }
}

TEST(Drag, OfBothKindsAddsUp) {
  // 2 v + 3 v^2 = 1
  EXPECT_NEAR(fall_speed(falling_disk(Method::automatic, {.linear = 2, .quadratic = 3}), 1e-2, 50),
              1.0 / 3, tolerance::exact());
}

// v = v_inf (1 - exp(-gamma t)), to first order: half the step, half the error.
TEST(Drag, ApproachesTheTerminalVelocityExponentiallyToFirstOrderInTheStep) {
  const double gamma = 2, t = 0.5, exact = (1 - std::exp(-gamma * t)) / gamma;
  const Scenario scene = falling_disk(Method::automatic, {.linear = gamma});
  const double coarse = fall_speed(scene, 1e-3, t) - exact;
  const double fine = fall_speed(scene, 5e-4, t) - exact;
  EXPECT_NEAR(fine, 0, tolerance::discretised());
  EXPECT_NEAR(coarse / fine, 2, tolerance::sampled(0.01));
  // v = v_inf tanh(t/v_inf)
  const double quadratic_error =
      fall_speed(falling_disk(Method::automatic, {.quadratic = 4}), 1e-4, t) -
      0.5 * std::tanh(2 * t);
  EXPECT_NEAR(quadratic_error, 0, tolerance::discretised());
}

TEST(Drag, IsImplicitAndNeverOvershootsWhateverTheStep) {
  Scenario scene = empty_scene(Method::automatic);
  scene.drag = Drag{.linear = 1e9, .quadratic = 1e9};
  scene.disks.push_back({.velocity = {7, 0}, .spin = 3});
  Simulation run(scene);
  run.advance();
  const Vec3& v = run.world.disks.velocity[0];
  EXPECT_GT(v.x(), 0);
  EXPECT_LT(v.x(), 1e-6);
  EXPECT_EQ(v.z(), 3) << "rotation is not damped";
}

// Disks of all sizes that collide and bond in free space.
TEST_P(ViscousDrag, OnlyTakesEnergyAway) {
  Scenario scene = falling_cluster(GetParam(), 12, 3, paper_law(5));
  scene.gravity.reset();
  scene.box.floor = false;
  scene.drag = Drag{.linear = 0.5, .quadratic = 0.2};
  Simulation run(scene);
  run.world.bonding = true;
  double energy = mechanical_energy(run.world);
  for (int k = 0; k < 300; ++k) {
    run.advance();
    const double now = mechanical_energy(run.world);
    ASSERT_LE(now, energy + tolerance::solved()) << "step " << k;
    energy = now;
  }
  EXPECT_GT(run.bonds_formed, 0);
}

// Contact impulses change the momentum of neither pair: m (v' - v) = -dt gamma v' each, so their sum
// decays as that of one body.
TEST_P(ViscousDrag, ActsOnAPairInContactAsOnItsBodies) {
  Scenario scene = empty_scene(GetParam());
  scene.grain_law = paper_law(50);
  scene.initial_bonds = InitialBonds::touching;
  scene.drag = Drag{.linear = 2};
  scene.disks = {{.position = {0, 0}, .velocity = {1, 0.5}}, {.position = {1, 0}}};
  Simulation run(scene);
  const int n = 100;
  run.advance(n);
  const double decay = std::pow(1 + 2 * run.step.dt, -n);
  EXPECT_NEAR(momentum(run.world).x(), decay, tolerance::solved());
  EXPECT_NEAR(momentum(run.world).y(), 0.5 * decay, tolerance::solved());
  EXPECT_LE(std::abs(run.world.gap({0, 1})), scene.grain_law.cohesion_range) << "still bonded";
}

TEST_P(ViscousDrag, OfNoStrengthChangesNoBit) {
  Scenario scene = falling_cluster(GetParam(), 12, 3, paper_law(5));
  Simulation plain(scene);
  scene.drag = Drag{};
  Simulation damped(scene);
  plain.advance(50), damped.advance(50);
  EXPECT_NE(world_hash(plain.world), world_hash(damped.world)) << "the term is part of the world";
  damped.world.drag.reset();
  EXPECT_EQ(world_hash(plain.world), world_hash(damped.world));
}

TEST(ModelTerms, NameTheDrag) {
  Scenario scene = empty_scene(Method::automatic);
  scene.drag = Drag{.linear = 1};
  EXPECT_EQ(model_terms(scene), (std::vector<std::string>{"volume exclusion", "drag"}));
}

}  // namespace
}  // namespace quicksand
