// How closely the breaking of a bond follows its closed forms, as a function of the time step. What is
// stated here is what holds, deviations included.
#include <cmath>

#include "core/problem/solver_settings.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

constexpr double kCohesion = 1e4;

QUICKSAND_PER_GLOBAL_SOLVER(SpinLimit);
QUICKSAND_PER_GLOBAL_SOLVER(ImpactLimit);
QUICKSAND_PER_GLOBAL_SOLVER(PullLimit);

// The load at which `breaks` turns true, between two bounds, to a thousandth.
template <class Breaks>
double threshold(double holding, double breaking, Breaks breaks) {
  EXPECT_FALSE(breaks(holding));
  EXPECT_TRUE(breaks(breaking));
  while (breaking - holding > 1e-3) {
    const double middle = (holding + breaking) / 2;
    (breaks(middle) ? breaking : holding) = middle;
  }
  return (holding + breaking) / 2;
}

// A rigid pair needs the centripetal force m w^2 d/2; `share` is that over F_c.
double spin(double share) { return std::sqrt(share * 2 * kCohesion); }

bool spinning_pair_breaks(Method method, double share, double dt) {
  Scenario scene = spinning_pair(method, spin(share), kCohesion);
  scene.step.dt = dt;
  Simulation run(scene);
  do {
    run.advance();
    EXPECT_TRUE(run.last.converged);
  } while (run.bonds_broken == 0 && (run.world.time < 0.1 || run.world.step < 20));
  return run.bonds_broken > 0;
}

// A pair that turns by w dt = 0.042 and less in a step has the limit of the closed form.
TEST_P(SpinLimit, IsTheClosedFormWhereThePairTurnsLittleInAStep) {
  for (double dt : {3e-4, 1e-4, 1e-5}) {
    EXPECT_FALSE(spinning_pair_breaks(GetParam(), 0.99, dt)) << dt;
    EXPECT_TRUE(spinning_pair_breaks(GetParam(), 1.01, dt)) << dt;
  }
}

// The curvature term is the first of a series in the angle w dt; what is left out weakens the bond by
// 0.3 (w dt)^2, and by a tenth where the pair turns by a radian in a step. Found for the paper's bond
// at dt = 1e-2, 5e-3, 3e-3, 1e-3, 3e-4: 0.908, 0.896, 0.948, 0.996, 1.000.
TEST_P(SpinLimit, FallsWithTheSquareOfTheTurnInAStep) {
  for (double dt : {1e-2, 5e-3, 3e-3, 1e-3, 3e-4, 1e-4}) {
    const double turn = spin(1) * dt;
    const double limit = threshold(
        0.7, 1.1, [&](double share) { return spinning_pair_breaks(GetParam(), share, dt); });
    EXPECT_LT(limit, 1 + tolerance::sampled(3e-3)) << dt;
    EXPECT_GT(limit, 1 - std::min(0.11, 0.35 * turn * turn) - tolerance::sampled(3e-3)) << dt;
  }
}

// Two free bonded grains torn apart with an energy of `share` F_c d_c in their opening mode.
double opening_speed(double share) { return std::sqrt(share * 2 * kCohesion * kRange / 0.5); }

bool impact_breaks(Method method, double share, double dt) {
  Scenario scene = pulled_pair(method, 0, kCohesion);
  scene.disks[0].fixed = false;
  scene.disk_forces.clear();
  scene.disks[0].velocity.x() = -opening_speed(share) / 2;
  scene.disks[1].velocity.x() = opening_speed(share) / 2;
  scene.step.dt = dt;
  Simulation run(scene);
  do {
    run.advance();
    EXPECT_TRUE(run.last.converged);
  } while (run.bonds_broken == 0 && (run.world.time < 1e-3 || run.world.step < 10));
  return run.bonds_broken > 0;
}

// At steps above sqrt(2 d_c m_red/F_c) = 7.07e-5 the energy criterion has the limit F_c d_c.
TEST_P(ImpactLimit, IsTheEnergyOfTheBondAtCoarseSteps) {
  for (double dt : {1e-2, 1e-3, 1e-4, 7.2e-5}) {
    const double limit =
        threshold(0.7, 3, [&](double share) { return impact_breaks(GetParam(), share, dt); });
    EXPECT_NEAR(limit, 1, tolerance::sampled(2e-3)) << dt;
  }
}

// Unequal masses, a held partner, and any direction: only the energy of the opening mode counts.
TEST_P(ImpactLimit, IsTheEnergyOfTheBondForAnyMassesInAnyDirection) {
  struct Partner {
    double density;
    bool fixed;
    double reduced_mass;
  };
  for (const Partner& partner :
       {Partner{1, true, 1}, Partner{4, false, 0.8}, Partner{1e4, false, 1e4 / (1e4 + 1)},
        Partner{0.01, false, 0.01 / 1.01}}) {
    for (double angle : {0.0, 0.7, 2.5}) {
      const auto breaks = [&](double share) {
        Scenario scene = pulled_pair(GetParam(), 0, kCohesion);
        scene.disk_forces.clear();
        scene.disks[0].density = partner.density;
        scene.disks[0].fixed = partner.fixed;
        scene.disks[1].velocity.x() =
            std::sqrt(share * 2 * kCohesion * kRange / partner.reduced_mass);
        Simulation run(rotated(scene, angle));
        run.advance(10);
        EXPECT_EQ(run.unconverged, 0);
        return run.bonds_broken > 0;
      };
      EXPECT_NEAR(threshold(0.7, 3, breaks), 1, tolerance::sampled(2e-3))
          << partner.reduced_mass << " " << angle;
    }
  }
}

// A pair that `load` F_c has pulled for a while, and then an impact with a share of what is left of the
// bond's energy, (F_c - F) d_c; pressed for a negative load.
bool loaded_pair_breaks(Method method, double load, double share, double dt) {
  Simulation run(pulled_pair(method, load * kCohesion, kCohesion));
  run.advance(5);
  EXPECT_EQ(run.bonds_broken, 0);
  run.step.dt = dt;
  run.world.disks.velocity[1].x() += std::sqrt(share * 2 * (1 - load) * kCohesion * kRange);
  run.advance(20);
  EXPECT_EQ(run.unconverged, 0);
  return run.bonds_broken > 0;
}

TEST_P(ImpactLimit, IsWhatALoadLeavesOfTheEnergy) {
  for (double load : {0.2, 0.5, 0.9}) {
    for (double dt : {1e-2, 3e-3, 1e-3}) {
      const double limit = threshold(
          0.7, 3, [&](double share) { return loaded_pair_breaks(GetParam(), load, share, dt); });
      EXPECT_NEAR(limit, 1, tolerance::sampled(2e-3)) << load << " at " << dt;
    }
  }
}

// Pressure alone does not keep a bond: pressed with F_c, an impact must do 2 F_c d_c of work to open it.
TEST_P(ImpactLimit, OfAPressedBondIsNotFarAboveItsEnergy) {
  for (double dt : {1e-2, 1e-3}) {
    EXPECT_FALSE(loaded_pair_breaks(GetParam(), -1, 0.45, dt)) << dt;
    EXPECT_TRUE(loaded_pair_breaks(GetParam(), -1, 1.05, dt)) << dt;
  }
}

// A bond that a collision has just pressed is no weaker for it: neither where the pair turns, at 0.25 % of what F_c
// holds, nor against an impact.
TEST_P(ImpactLimit, DoesNotDependOnACollisionBefore) {
  for (double dt : {1e-2, 3e-3, 1e-3}) {
    for (double speed : {2.0, 10.0, 50.0}) {
      const auto struck = [&](double share, double across) {
        Scenario scene = pulled_pair(GetParam(), 0, kCohesion);
        scene.disks[1].velocity = {-speed, across};
        scene.step.dt = dt;
        Simulation run(scene);
        run.advance();
        run.world.disks.velocity[1].x() += std::sqrt(share * 2 * kCohesion * kRange);
        run.advance(5);
        EXPECT_EQ(run.unconverged, 0);
        return run.bonds_broken > 0;
      };
      EXPECT_FALSE(struck(0, 5)) << dt << " " << speed;
      EXPECT_FALSE(struck(0.99, 0)) << dt << " " << speed;
      EXPECT_TRUE(struck(1.01, 0)) << dt << " " << speed;
    }
  }
}

// How far implicit Euler lets the pair open: every step takes F_c W dt from the speed before it moves.
double implicit_euler_opening(double share, double dt) {
  double speed = opening_speed(share), gap = 0;
  while ((speed -= 2 * kCohesion * dt) > 0) gap += speed * dt;
  return gap;
}

// Below it nothing is suspected, and the opening is resolved by implicit Euler, which dissipates: the
// bond holds (1 + dt/(2 * 7.07e-5))^2 F_c d_c, 2.23 at 7e-5, 1.15 at 1e-5, 1.01 at 1e-6.
TEST_P(ImpactLimit, IsThatOfImplicitEulerAtFineSteps) {
  for (double dt : {7e-5, 5e-5, 3e-5, 1e-5, 3e-6, 1e-6}) {
    const double limit =
        threshold(0.7, 3, [&](double share) { return impact_breaks(GetParam(), share, dt); });
    const double expected =
        threshold(0.7, 3, [&](double share) { return implicit_euler_opening(share, dt) > kRange; });
    EXPECT_NEAR(limit, expected, tolerance::sampled(2e-3)) << dt;
    // Smoothed over the whole numbers of steps that it takes to open.
    const double smooth = std::pow(1 + dt / (2 * std::sqrt(kRange / kCohesion)), 2);
    EXPECT_NEAR(limit, smooth, tolerance::sampled(0.1 * smooth)) << dt;
  }
}

// Above any sudden pull the bond opens with what F_c leaves, here F_g: by d_c within 0.01.
TEST_P(PullLimit, OfASuddenPullIsTheCohesionForceAtAnyStep) {
  for (double dt : {1e-2, 1e-3, 1e-4, 1e-5}) {
    for (double share : {1 - 1e-4, 1 + 1e-4}) {
      Scenario scene = pulled_pair(GetParam(), share * kCohesion, kCohesion);
      scene.step.dt = dt;
      Simulation run(scene);
      run.run_for(0.05);
      EXPECT_EQ(run.unconverged, 0);
      EXPECT_EQ(run.bonds_broken, share > 1 ? 1 : 0) << share << " at " << dt;
    }
  }
}

}  // namespace
}  // namespace quicksand
