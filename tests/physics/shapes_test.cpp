// Bodies of several parts against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/shapes/intruder_shapes.h"
#include "core/world/shaped_contact.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(ShapedBodies);

// A plate along x whose overall length and thickness these are.
std::vector<ConvexPart> plate_along_x(double length, double thickness) {
  const double half = (length - thickness) / 2;
  return {{{{-half, 0}, {half, 0}}, thickness / 2}};
}

TEST_P(ShapedBodies, OfOneDiskMoveAsADiskToTheLastBit) {
  Scenario scene = falling_cluster(GetParam(), 16, 3, paper_law(50));
  scene.solver.tolerance = 1e-6;
  scene.step.dt = 5e-3;
  const Disk ball{.position = {1.7, -1.2},
                  .radius = 0.8,
                  .density = 1.7,
                  .velocity = {0.2, 1.5},
                  .spin = -3,
                  .role = DiskRole::intruder};
  scene.box.floor = false;
  scene.walls.push_back({.point = {0, -2.2}});
  Simulation as_disk(scene), as_shape(scene);
  as_disk.world.disks.add(ball);
  add_shape(as_shape.world, ball, std::vector<ConvexPart>{{{{5, 6}}, 0.8}});
  for (Simulation* run : {&as_disk, &as_shape}) {
    run->world.bonding = true;
    run->advance(300);
  }
  EXPECT_GT(as_disk.bonds_formed, 10);
  const Disks &a = as_disk.world.disks, &b = as_shape.world.disks;
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.angle, b.angle);
}

TEST_P(ShapedBodies, CapsuleOnAnInclineSlidesAtTheFrictionAngleAndDoesNotRoll) {
  constexpr double kMu = 0.4;
  for (const double slope : {0.99 * kMu, 0.7}) {
    Scenario scene = incline(GetParam(), slope, {.friction = kMu});
    scene.disks.clear();
    Simulation run(scene);
    add_shape(run.world, {}, plate_along_x(3, 1));
    run.world.disks.angle[0] = -std::atan(slope);
    run.run_for(2);
    EXPECT_EQ(run.unconverged, 0);
    const double angle = std::atan(slope);
    const double expected = std::max(0.0, 2 * (std::sin(angle) - kMu * std::cos(angle)));
    EXPECT_NEAR(run.world.disks.velocity[0].head<2>().norm(), expected, tolerance::solved());
    EXPECT_NEAR(run.world.disks.velocity[0].z(), 0, tolerance::solved());
  }
}

// A plate whose centre is at x on two fixed disks at -2 and 2.
Simulation plate_on_two_disks(Method method, double x) {
  Scenario scene = empty_scene(method);
  scene.gravity = Vec2(0, -1);
  scene.disks = {{.position = {-2, 0}, .fixed = true}, {.position = {2, 0}, .fixed = true}};
  Simulation run(scene);
  add_shape(run.world, {.position = {x, 0.75}}, plate_along_x(12, 0.5));
  return run;
}

TEST_P(ShapedBodies, PlateOnTwoDisksLoadsThemAsStaticsSays) {
  for (const double x : {-1.9, -1.0, 0.0, 0.5, 1.99}) {
    Simulation run = plate_on_two_disks(GetParam(), x);
    run.advance(3);
    EXPECT_EQ(run.unconverged, 0);
    const double weight = run.world.disks.mass[2];
    const double left = weight * (2 - x) / 4;
    EXPECT_NEAR(contact_force(run.world, {0, kCornerBase}).y(), left, tolerance::solved(weight));
    EXPECT_NEAR(contact_force(run.world, {1, kCornerBase}).y(), weight - left,
                tolerance::solved(weight));
    EXPECT_LE(run.world.disks.velocity[2].norm(), tolerance::solved());
  }
}

TEST_P(ShapedBodies, PlateTipsOverBeyondItsSupport) {
  Simulation rests = plate_on_two_disks(GetParam(), 1.99);
  rests.run_for(0.5);
  EXPECT_NEAR(rests.world.disks.velocity[2].z(), 0, tolerance::solved());
  Simulation tips = plate_on_two_disks(GetParam(), 2.01);
  tips.run_for(0.5);
  // About the edge, m g x = (I + m x^2) alpha.
  const double inertia = tips.world.shapes.bodies[0].inertia / tips.world.disks.mass[2];
  EXPECT_NEAR(tips.world.disks.velocity[2].z(), -0.5 * 0.01 / (inertia + 1e-4),
              tolerance::scaled(1e-4));
}

// A lever with a weight at each end on one disk: in equilibrium where the moments are equal, else it turns.
TEST_P(ShapedBodies, LeverIsInEquilibriumWhereTheMomentsAre) {
  for (const double density : {2.0, 2.1}) {
    Scenario scene = empty_scene(GetParam());
    scene.gravity = Vec2(0, -1);
    scene.grain_law = {.friction = 0.5};
    scene.disks = {{.position = {0, 0}, .fixed = true},
                   {.position = {-1.5, 1.5}, .density = density},
                   {.position = {3, 1.5}}};
    scene.grain_law.rolling_friction = 1e-4;
    Simulation run(scene);
    add_shape(run.world, {.position = {0, 0.75}}, plate_along_x(8, 0.5));
    run.advance(20);
    EXPECT_EQ(run.unconverged, 0);
    const double spin = run.world.disks.velocity[3].z();
    if (density == 2) {
      EXPECT_NEAR(spin, 0, tolerance::solved());
      EXPECT_NEAR(contact_force(run.world, {0, kCornerBase}).y(), run.world.disks.mass[3] + 3,
                  tolerance::solved(10));
    } else {
      EXPECT_GT(spin, 1e-4);
    }
  }
}

TEST_P(ShapedBodies, FreeRotationKeepsEnergyAndAngularMomentum) {
  Simulation run(empty_scene(GetParam()));
  add_shape(run.world, {.velocity = {0.3, -0.2}, .spin = 1.7},
            std::vector<ConvexPart>{{{{-1, 0}, {3, 0}}, 0.3}, {{{3, 0}, {3, 1}, {2.5, 2}}, 0.2}});
  const double before = mechanical_energy(run.world);
  run.advance(10000);
  EXPECT_NEAR(mechanical_energy(run.world), before, tolerance::exact());
  EXPECT_EQ(run.world.disks.velocity[0], Vec3(0.3, -0.2, 1.7));
  EXPECT_NEAR(run.world.disks.angle[0], 170, tolerance::exact(170));
}

// Two disks hit a free plate at once: against the linear complementarity problem, all cases of which are tried.
TEST_P(ShapedBodies, ImpactOfTwoDisksIsTheSolutionOfTheComplementarityProblem) {
  const double x[] = {-1.2, 2.3}, mass[] = {1, 3};
  for (const auto& [first, second] : {std::pair{1.0, 2.0}, {3.0, 0.1}, {0.05, 2.0}, {1.0, 1.0}}) {
    Scenario scene = empty_scene(GetParam());
    scene.disks = {{.position = {x[0], -0.75}, .velocity = {0, first}},
                   {.position = {x[1], -0.75}, .density = mass[1], .velocity = {0, second}}};
    Simulation run(scene);
    add_shape(run.world, {}, plate_along_x(6, 0.5));
    run.advance();
    EXPECT_EQ(run.unconverged, 0);

    const double m = run.world.disks.mass[2], inertia = run.world.shapes.bodies[0].inertia;
    Eigen::Matrix2d w;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        w(i, j) = 1 / m + x[i] * x[j] / inertia + (i == j ? 1 / mass[i] : 0);
    const Vec2 q(-first, -second);
    std::optional<Vec2> impulse;
    for (int active = 0; active < 4; ++active) {
      Vec2 p(0, 0);
      if (active == 3) p = -w.inverse() * q;
      if (active == 1) p.x() = -q.x() / w(0, 0);
      if (active == 2) p.y() = -q.y() / w(1, 1);
      const Vec2 u = w * p + q;
      if (p.minCoeff() >= 0 && u.minCoeff() >= -1e-12) impulse = p;
    }
    ASSERT_TRUE(impulse);
    EXPECT_NEAR(run.world.disks.velocity[2].y(), impulse->sum() / m, tolerance::solved());
    EXPECT_NEAR(run.world.disks.velocity[2].z(),
                (x[0] * impulse->x() + x[1] * impulse->y()) / inertia, tolerance::solved());
  }
}

// Two disks that touch, as one body and as a pair whose bond lets nothing go, stand tilted on a slippery floor.
TEST_P(ShapedBodies, OfTwoDisksFallAsAPairInARigidBond) {
  Scenario scene = empty_scene(GetParam());
  scene.gravity = Vec2(0, -1);
  scene.walls.push_back({});
  scene.grain_law = {.friction = 100, .rolling_friction = 100, .cohesion_force = 1e4};
  scene.wall_law = scene.intruder_law = ContactLaw{.friction = 0.3};
  const Vec2 along(std::cos(0.7), std::sin(0.7)), foot(0, 0.5);
  Scenario pair_scene = scene;
  pair_scene.disks = {{.position = foot}, {.position = foot + along}};
  Simulation pair(pair_scene), body(scene);
  pair.world.bonds.form({{0, 1}});
  add_shape(body.world, {.position = foot + along / 2},
            std::vector<ConvexPart>{{{{0, 0}}, 0.5}, {{along}, 0.5}});
  pair.advance();
  body.advance();
  const std::vector<Vec3>& of_pair = pair.world.disks.velocity;
  const Vec3& of_body = body.world.disks.velocity[0];
  EXPECT_GT(std::abs(of_body.z()), 1e-3);
  EXPECT_LE(distance(of_body, Vec3((of_pair[0] + of_pair[1]) / 2)), tolerance::solved());
}

// A cone sinks between two disks that are drawn apart, and slides along both: F = 2 N (sin + mu cos).
TEST_P(ShapedBodies, ConeFeelsAFrictionalWedge) {
  constexpr double kMu = 0.3, kForce = 7, kHalfAngle = std::numbers::pi / 6, kApart = 0.2;
  Scenario scene = empty_scene(GetParam());
  scene.grain_law = {.friction = kMu};
  const ConeIntruder cone{.width = 4, .angle = 60, .rounding = 0.2};
  const std::vector<ConvexPart> parts = parts_of(cone);
  const Vec2 tip = parts[0].corners[0], edge = parts[0].corners[1];
  const Vec2 outward(std::cos(kHalfAngle), -std::sin(kHalfAngle));
  const Vec2 right = (tip + edge) / 2 + (0.2 + 0.5) * outward;
  scene.disks = {{.position = right, .velocity = {kApart, 0}, .fixed = true},
                 {.position = {-right.x(), right.y()}, .velocity = {-kApart, 0}, .fixed = true}};
  Simulation run(scene);
  const double sinks = -kApart / std::tan(kHalfAngle);
  const int body = add_shape(
      run.world, {.position = mass_properties(parts).centre, .velocity = {0, sinks}}, parts);
  run.world.disks.applied[body] = {0, -kForce, 0};
  run.advance(10);
  EXPECT_EQ(run.unconverged, 0);
  EXPECT_NEAR(run.world.disks.velocity[body].y(), sinks, tolerance::solved());
  const double normal = kForce / (2 * (std::sin(kHalfAngle) + kMu * std::cos(kHalfAngle)));
  for (const Contact& contact : run.world.contacts) {
    EXPECT_NEAR(contact.impulse.x() / run.step.dt, normal, tolerance::solved(10));
    EXPECT_NEAR(std::abs(contact.impulse.y()) / run.step.dt, kMu * normal, tolerance::solved(10));
  }
  EXPECT_EQ(run.world.contacts.size(), 2U);
}

// Bonds of grains to a spinning plate, one at its flank and one at its end, hold, and take no energy.
TEST_P(ShapedBodies, SpinningPlateKeepsTheGrainsThatAreBondedToIt) {
  Scenario scene = empty_scene(GetParam());
  scene.grain_law = paper_law(1e4);
  constexpr double kSpin = 2;
  scene.step.dt = 1e-3;
  for (const Vec2& place : {Vec2(0.8, 0.75), Vec2(2.5, 0), Vec2(-0.8, -0.75), Vec2(-2.5, 0)})
    scene.disks.push_back(
        {.position = place, .velocity = kSpin * perpendicular(place), .spin = kSpin});
  Simulation run(scene);
  add_shape(run.world, {.spin = kSpin}, plate_along_x(4, 0.5));
  run.world.bonds.form(bondable_pairs(run.world));
  ASSERT_EQ(run.world.bonds.list.size(), 4U);
  const double before = mechanical_energy(run.world);
  run.run_for(3);
  EXPECT_EQ(run.bonds_broken, 0);
  EXPECT_NEAR(mechanical_energy(run.world) / before, 1, tolerance::scaled(2e-3));
}

// A thin blade through a cloud of grains at up to a hundred times sqrt(g d), a diameter a step: none gets through it. That
// it turns within a step is known to second order: in one of 0.15 rad a point far out deviates by 0.13 d from its tangent.
TEST_P(ShapedBodies, NoGrainPassesThroughAThinBlade) {
  constexpr double kRounding = 0.01, kReach = 12;
  for (const double spin : {0.0, 2.0, 15.0}) {
    Scenario scene = empty_scene(GetParam());
    scene.solver.tolerance = 1e-6;
    for (int k = 0; k < 12; ++k)
      scene.disks.push_back({.position = {3 + 1.3 * (k / 4), 1.02 * (k % 4) - 1.5}});
    Simulation run(scene);
    // Along y; as it turns it sweeps over the grains clockwise.
    const int blade = add_shape(run.world,
                                {.position = spin == 0 ? Vec2(0, 0) : Vec2(3, -8),
                                 .velocity = {spin == 0 ? 100 : 0, 0},
                                 .spin = -spin,
                                 .fixed = true},
                                std::vector<ConvexPart>{{{{0, -30}, {0, 30}}, kRounding}});
    if (spin > 0) run.world.disks.angle[blade] = 0.6;
    const double turn = spin * run.step.dt;
    const double least = 0.5 + kRounding - kReach * turn * turn - tolerance::solved();
    const int steps = spin == 0 ? 10 : static_cast<int>(1.2 / turn);
    for (int k = 0; k < steps; ++k) {
      run.advance();
      const double angle = run.world.disks.angle[blade];
      const Vec2 ahead(std::cos(angle), std::sin(angle));
      for (int i = 0; i < 12; ++i)
        EXPECT_GT(ahead.dot(run.world.separation(blade, i)), least)
            << i << " in step " << k << " at a spin of " << spin;
    }
  }
}

}  // namespace
}  // namespace quicksand
