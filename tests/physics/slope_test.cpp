#include <cmath>

#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Slope);

constexpr double kMu = 0.4, kRolling = 0.1;

// So much rolling friction that the disk cannot turn, hence must slide.
const ContactLaw kSlider{.friction = kMu, .rolling_friction = 100};
// So much friction that it cannot slide, hence must roll.
const ContactLaw kRoller{.friction = 10, .rolling_friction = kRolling};

// Speed along the slope after a time.
double speed(const Scenario& scene, double time) {
  Simulation run(scene);
  run.run_for(time);
  EXPECT_EQ(run.unconverged, 0);
  return run.world.disks.velocity[0].head<2>().norm();
}

TEST_P(Slope, DiskThatCannotRollRestsBelowTheFrictionAngle) {
  EXPECT_LE(speed(incline(GetParam(), 0.99 * kMu, kSlider), 5), tolerance::solved());
}

TEST_P(Slope, DiskThatCannotRollSlidesAboveTheFrictionAngle) {
  // 1 % above, sin - mu cos = 0.0037.
  EXPECT_GT(speed(incline(GetParam(), 1.01 * kMu, kSlider), 5), 0.015);
}

TEST_P(Slope, DiskRestsBelowTheRollingFrictionAngle) {
  EXPECT_LE(speed(incline(GetParam(), 0.99 * kRolling, kRoller), 5), tolerance::solved());
}

TEST_P(Slope, DiskRollsAboveTheRollingFrictionAngle) {
  // 1 % above, 2/3 (sin - c cos) = 0.00066.
  EXPECT_GT(speed(incline(GetParam(), 1.01 * kRolling, kRoller), 5), 0.003);
}

TEST_P(Slope, DiskWithoutRollingFrictionRollsOnAnySlope) {
  EXPECT_GT(speed(incline(GetParam(), 0.001, {.friction = kMu}), 5), 0.003);
}

// The velocities of implicit Euler are exact at the steps under constant forces.
TEST_P(Slope, SlidingAccelerationIsSineMinusMuCosine) {
  const double angle = std::atan(0.7);
  const double expected = 2 * (std::sin(angle) - kMu * std::cos(angle));
  EXPECT_NEAR(speed(incline(GetParam(), 0.7, kSlider), 2), expected, tolerance::solved());
}

TEST_P(Slope, RollingAccelerationIsTwoThirdsOfTheDrivingForce) {
  const double angle = std::atan(0.7);
  const double expected = 2 * 2.0 / 3 * (std::sin(angle) - kRolling * std::cos(angle));
  EXPECT_NEAR(speed(incline(GetParam(), 0.7, kRoller), 2), expected, tolerance::solved());
}

TEST_P(Slope, RollingDiskDoesNotSlip) {
  Simulation run(incline(GetParam(), 0.7, kRoller));
  run.run_for(2);
  const Vec3 v = run.world.disks.velocity[0];
  EXPECT_NEAR(-v.z() * 0.5, v.head<2>().norm(), tolerance::solved());
}

// Above tan = 3 mu a disk without rolling friction slips, and spins up by mu m g cos alone.
TEST_P(Slope, DiskSlipsWhileItRollsOnASteepSlope) {
  const double slope = 3.3 * kMu, angle = std::atan(slope), t = 2;
  Simulation run(incline(GetParam(), slope, {.friction = kMu}));
  run.run_for(t);
  const Vec3 v = run.world.disks.velocity[0];
  EXPECT_NEAR(v.head<2>().norm(), t * (std::sin(angle) - kMu * std::cos(angle)),
              tolerance::solved());
  EXPECT_NEAR(v.z(), -t * kMu * std::cos(angle) * 0.5 * 8, tolerance::solved(10));
}

// Rolling friction takes its share of mu: slip begins at tan = 3 mu - 2 c.
TEST_P(Slope, RollingFrictionLetsTheDiskSlipEarlier) {
  const ContactLaw law{.friction = kMu, .rolling_friction = kRolling};
  const auto slip = [&](double slope) {
    Simulation run(incline(GetParam(), slope, law));
    run.run_for(2);
    const Vec3 v = run.world.disks.velocity[0];
    return v.head<2>().norm() + v.z() * 0.5;
  };
  const double limit = 3 * kMu - 2 * kRolling;
  EXPECT_NEAR(slip(0.99 * limit), 0, tolerance::solved());
  EXPECT_GT(slip(1.01 * limit), 0.01);
}

TEST_P(Slope, FrictionlessDiskSlidesDownWithoutTurning) {
  Simulation run(incline(GetParam(), 0.7, {}));
  run.run_for(2);
  EXPECT_NEAR(run.world.disks.velocity[0].head<2>().norm(), 2 * std::sin(std::atan(0.7)),
              tolerance::solved());
  EXPECT_EQ(run.world.disks.velocity[0].z(), 0);
}

// A bond to the slope adds F_c to the normal force that friction may use, up to its own limit.
TEST_P(Slope, CohesionRaisesTheFrictionAngle) {
  const double angle = std::atan(2.0), cohesion = 5;
  for (double share : {0.99, 1.01}) {
    ContactLaw law = kSlider;
    law.cohesion_force = cohesion;
    law.friction = share * std::sin(angle) / (std::cos(angle) + cohesion);
    Scenario scene = incline(GetParam(), 2, law);
    scene.initial_bonds = InitialBonds::touching;
    if (share > 1) {
      EXPECT_LE(speed(scene, 2), tolerance::solved());
    } else {
      EXPECT_GT(speed(scene, 2), 0.01);
    }
  }
}

}  // namespace
}  // namespace quicksand
