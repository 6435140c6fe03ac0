// Intruders that are driven: penetration and vane.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/errors.h"
#include "core/forces/reaction.h"
#include "core/measures/measures.h"
#include "core/phases/drive.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"
#include "core/world/extent.h"
#include "core/world/shaped_contact.h"
#include "core/world/world.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

QUICKSAND_PER_GLOBAL_SOLVER(Drives);

// A bed of columns of grains with room between them, and then the phase.
constexpr int kColumns = 11;
Scenario bed(Method method, const Phase& phase, double cohesion = 100) {
  Scenario scene = empty_scene(method);
  scene.box = {.width = 14, .height = 14, .sides = Sides::periodic, .floor = true};
  scene.gravity = Vec2(0, -1);
  scene.grain_law = paper_law(cohesion);
  scene.initial_bonds = InitialBonds::touching;
  scene.solver.tolerance = 1e-6;
  scene.step.dt = 5e-3;
  scene.step.stop_if_unconverged = true;
  for (int row = 0; row < 6; ++row)
    for (int k = 0; k < kColumns; ++k)
      scene.disks.push_back({.position = {14.0 / kColumns * (k + 0.3), 0.5 + row}});
  scene.phases = {phase};
  return scene;
}

const Phase kCone{PenetratePhase{.shape = ConeIntruder{.width = 2, .length = 1.5},
                                 .speed = 1.0,
                                 .ramp_time = 0.2,
                                 .depth = 1.5}};

TEST_P(Drives, ConeAtAGivenSpeedGetsToItsDepthAndMeetsResistance) {
  const Scenario scene = bed(GetParam(), kCone);
  Protocol run(scene, make_world(scene));
  double work = 0, way = 0;
  for (;;) {
    const double before = run.world().time;
    const Progress progress = run.advance();
    ASSERT_NE(progress, Progress::failed) << run.failure();
    if (progress != Progress::running) break;
    const World& world = run.world();
    const Reaction reaction = reaction_on(world, world.intruder());
    const double downward = -world.disks.velocity[world.intruder()].y() * (world.time - before);
    way += downward;
    work += downward * reaction.force.y();
    const double scale = 1 + reaction.force.norm();
    EXPECT_NEAR(reaction.normal + reaction.tangential, reaction.force.y(),
                tolerance::rounding(scale));
    EXPECT_NEAR(reaction.front + reaction.flank + reaction.shaft, reaction.force.y(),
                tolerance::rounding(scale));
    EXPECT_EQ(world.disks.velocity[world.intruder()].z(), 0);
  }
  ASSERT_EQ(run.state().drive_results.size(), 1U);
  const DriveResult& found = run.state().drive_results[0];
  EXPECT_GE(found.way, 1.5);
  EXPECT_LE(found.way, 1.5 + 2 * scene.step.dt);
  EXPECT_GT(found.peak, 10);
  EXPECT_GT(found.residual, 0);
  EXPECT_NEAR(found.mean.value() / (work / way), 1, 0.02) << "the last step is not among these";
  // The drive did the work that was lost or is in the packing.
  EXPECT_GT(run.state().external_work, 0);
  EXPECT_LE(run.state().energy_gained, 0.02 * run.state().external_work);
  // Held after the end.
  EXPECT_TRUE(run.world().disks.fixed(run.world().intruder()));
  EXPECT_EQ(run.world().disks.velocity[run.world().intruder()].norm(), 0);
}

TEST_P(Drives, LoadOfAPenetrationIsTheImpulseOverTheTime) {
  // Against one fixed grain a plate of weight W under a force F at rest feels W + F.
  Scenario scene = empty_scene(GetParam());
  scene.box = {.width = 20, .height = 5, .sides = Sides::walls, .floor = true};
  scene.gravity = Vec2(0, -1);
  scene.disks = {{.position = {10, 0.5}}};
  scene.phases = {{PenetratePhase{.shape = DiskIntruder{.diameter = 2},
                                  .force = 30,
                                  .ramp_time = 0.1,
                                  .depth = 5,
                                  .rest_time = 0.2,
                                  .max_time = 2}}};
  Protocol run(scene, make_world(scene));
  EXPECT_EQ(finish_phase(run), Progress::phase_ended);
  const World& world = run.world();
  EXPECT_TRUE(world.shapes.empty());
  EXPECT_NEAR(reaction_on(world, 1).force.y(), 4 + 30, tolerance::solved(34));
  EXPECT_FALSE(run.missed_rest());
}

TEST_P(Drives, VaneAgainstFixedGrainsFeelsTheTorqueThatTurnsIt) {
  Scenario scene = empty_scene(GetParam());
  scene.box = {.width = 30, .height = 30, .sides = Sides::open, .floor = false};
  scene.grain_law = {.friction = 0.3};
  // In front of each blade, 1.5 from the axis.
  constexpr double kThickness = 0.4, kArm = 1.5;
  for (const auto& along : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
    scene.disks.push_back(
        {.position = Vec2(15, 10) + kArm * along + (0.5 + kThickness / 2) * perpendicular(along),
         .fixed = true});
  // The packing ends at the top of the upper grain.
  const double top = 10 + kArm + 0.5;
  scene.phases = {{VanePhase{.shape = VaneIntruder{.radius = 2.5, .thickness = kThickness},
                             .x = 15.0,
                             .depth = top - 10,
                             .torque = 12,
                             .rest_time = 0.05,
                             .max_time = 0.2}}};
  Protocol run(scene, make_world(scene));
  EXPECT_EQ(finish_phase(run), Progress::phase_ended);
  const World& world = run.world();
  EXPECT_NEAR(reaction_on(world, 4).torque, -12, tolerance::solved(12));
  EXPECT_LE(world.disks.velocity[4].norm(), tolerance::solved());
  double moment = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec2 force = -contact_force(world, {k, kCornerBase + 2 * k});
    const Vec2 arm = world.disks.position[k] - world.disks.position[4];
    // Of the force of the blade on the grain, about the axis; friction acts half a grain nearer to it.
    const Vec2 along =
        kArm * Vec2(std::cos(k * std::numbers::pi / 2), std::sin(k * std::numbers::pi / 2));
    const Vec2 at = along + kThickness / 2 * perpendicular(along) / kArm;
    EXPECT_LE((arm - at).norm(), 0.5 + 1e-6);
    moment += at.x() * force.y() - at.y() * force.x();
  }
  EXPECT_NEAR(moment, 12, tolerance::solved(12));
}

const Phase kVane{VanePhase{.shape = VaneIntruder{.radius = 1.8, .thickness = 0.3},
                            .depth = 3,
                            .clear = true,
                            .angular_velocity = 2.0,
                            .ramp_time = 0.05,
                            .angle = 0.8}};

TEST_P(Drives, VaneTakesTheGrainsInItsWayOutAndTurns) {
  Scenario scene = bed(GetParam(), kVane);
  scene.disks.clear();
  constexpr int kGrains = 70;
  scene.phases = {{DepositPhase{.grains = kGrains, .interval = 0}}, kVane};
  Protocol run(scene, make_world(scene));
  EXPECT_EQ(finish_phase(run), Progress::phase_ended) << run.failure();
  EXPECT_EQ(finish_phase(run), Progress::phase_ended) << run.failure();
  ASSERT_EQ(run.state().drive_results.size(), 1U);
  const DriveResult& found = run.state().drive_results[0];
  EXPECT_GT(found.cleared, 2);
  EXPECT_EQ(run.world().disks.size(), kGrains + 1 - found.cleared);
  EXPECT_GE(found.way, 0.8);
  EXPECT_GT(found.peak, 0);
  EXPECT_NEAR(found.radius, 1.8, tolerance::rounding(10));
  EXPECT_NEAR(run.world().disks.angle.back(), found.way, tolerance::rounding());
  EXPECT_LE(run.state().worst_overlap, 1e-3);
}

// A search tells two torques: with the lower one the vane comes to rest on its way, with the higher it gets to the end.
TEST_P(Drives, CriticalTorqueSeparatesAVaneThatRestsFromOneThatTurns) {
  const VanePhase vane{.shape = VaneIntruder{.radius = 2.6, .thickness = 0.2},
                       .depth = 3,
                       .clear = true,
                       .torque = 100,
                       .angle = 1.2,
                       .max_time = 40};
  const auto after = [&](const VanePhase& phase) {
    // Columns that are bonded to the floor, and no weight.
    Scenario scene = bed(GetParam(), {phase});
    scene.gravity.reset();
    Protocol run(scene, make_world(scene));
    EXPECT_EQ(finish_phase(run), Progress::phase_ended) << run.failure();
    return run.state();
  };
  VanePhase searched = vane;
  searched.threshold = CriticalDrive{.tolerance = 0.2};
  const ProtocolState found = after(searched);
  EXPECT_TRUE(found.drive_results.empty());
  ASSERT_EQ(found.critical_forces.size(), 1U);
  const CriticalForce& critical = found.critical_forces[0];
  EXPECT_EQ(critical.kind, SearchKind::vane);
  ASSERT_TRUE(critical.force_high && critical.bracketed() && critical.force_low > 0)
      << critical.force_low << " " << critical.force_held << " " << critical.force_high.value_or(-1)
      << " of " << critical.trials << ", undecided " << critical.undecided;
  EXPECT_LE(*critical.force_high - critical.force_low, 0.2 * *critical.force_high);
  VanePhase by_torque = vane;
  by_torque.torque = *critical.force_high;
  EXPECT_GE(after(by_torque).drive_results.at(0).way, vane.angle);
  by_torque.torque = critical.force_low;
  EXPECT_LT(after(by_torque).drive_results.at(0).way, vane.angle);
}

TEST(Vane, AmongGrainsIsRefusedUnlessTheyAreCleared) {
  Scenario scene = bed(Method::automatic, kVane);
  std::get<VanePhase>(scene.phases[0].kind).clear = false;
  Protocol run(scene, make_world(scene));
  const std::uint64_t before = world_hash(run.world());
  for (int again = 0; again < 2; ++again) {
    try {
      run.advance();
      FAIL() << "was not refused";
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), "phases[0].clear");
      EXPECT_NE(std::string(error.what()).find("\"clear\": true"), std::string::npos)
          << error.what();
    }
    EXPECT_EQ(world_hash(run.world()), before) << "a refusal changes nothing";
    EXPECT_EQ(run.phase_progress(), 0);
  }
}

TEST(Vane, StrengthIsTheTorqueOverTheCircleOfItsTips) {
  EXPECT_NEAR(vane_strength(2 * std::numbers::pi * 9 * 5, 3), 5, tolerance::rounding(10));
}

TEST_P(Drives, IntruderThatWasPressedInCanBeTurned) {
  Scenario scene = bed(GetParam(), kCone, 0);
  scene.phases.push_back({VanePhase{.angular_velocity = 1.0, .angle = 0.1}});
  Protocol run(scene, make_world(scene));
  EXPECT_EQ(finish_phase(run), Progress::phase_ended) << run.failure();
  EXPECT_EQ(finish_phase(run), Progress::phase_ended) << run.failure();
  ASSERT_EQ(run.state().drive_results.size(), 2U);
  EXPECT_EQ(run.state().drive_results[1].drive, Drive::vane);
  EXPECT_GE(run.state().drive_results[1].way, 0.1);
}

std::string verdict_on(const Scenario& scene) {
  try {
    validate(scene);
  } catch (const InputError& error) {
    return error.where() + " " + error.what();
  }
  return "valid";
}

TEST(Validation, RefusesTwoIntrudersAndWhatFallsOnAShapedOne) {
  Scenario scene = bed(Method::automatic, kCone);
  EXPECT_EQ(verdict_on(scene), "valid");
  scene.phases = {kCone, kVane};
  EXPECT_NE(verdict_on(scene).find("phases[1]"), std::string::npos) << verdict_on(scene);
  scene.phases = {kCone, {DepositPhase{.grains = 3}}};
  EXPECT_NE(verdict_on(scene).find("phases[1]"), std::string::npos) << verdict_on(scene);
  scene.phases = {{VanePhase{.angular_velocity = 1.0}}};
  EXPECT_NE(verdict_on(scene).find("turns the intruder"), std::string::npos) << verdict_on(scene);
  scene.phases = {kCone};
  scene.step.nscd = Nscd{};
  EXPECT_NE(verdict_on(scene).find("nscd"), std::string::npos) << verdict_on(scene);
}

TEST(Validation, RefusesAShapeThatMeetsItselfAroundTheBox) {
  Scenario scene = bed(Method::automatic, kCone);
  std::get<PenetratePhase>(scene.phases[0].kind).shape = PlateIntruder{.width = 6};
  EXPECT_NE(verdict_on(scene).find("box.width"), std::string::npos) << verdict_on(scene);
}

// The bed is left with a cone that is held; to be pulled it must be let go.
TEST(PullAfterADrive, FindsAForceForAnIntruderThatWasHeld) {
  Phase cone = kCone;
  std::get<PenetratePhase>(cone.kind).depth = 0.5;
  Scenario scene = bed(Method::automatic, cone);
  scene.phases.push_back(
      {PullPhase{.trials = {.first_force = 8, .tolerance = 0.3, .rest_time = 0.1, .max_time = 1},
                 .distance = 0.3}});
  Protocol run(scene, make_world(scene));
  finish_phase(run);
  ASSERT_TRUE(run.world().disks.fixed(run.world().intruder()));
  finish_phase(run);
  ASSERT_EQ(run.state().critical_forces.size(), 1U);
  EXPECT_TRUE(run.state().critical_forces[0].force_high) << "moved at no force";
}

// A plate rocks on one grain: its centre hardly moves, its tips do.
TEST(RestOfADrive, IsThatOfTheTips) {
  Scenario scene = empty_scene(Method::automatic);
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 20, .height = 10, .sides = Sides::walls, .floor = true};
  scene.grain_law = {.friction = 1};
  scene.step.dt = 5e-3;
  scene.disks = {{.position = {10, 3}, .fixed = true}};
  scene.phases = {{PenetratePhase{.shape = PlateIntruder{.width = 4, .thickness = 0.1},
                                  .x = 10.01,
                                  .depth = 3,
                                  .max_time = 3}}};
  Protocol run(scene, make_world(scene));
  finish_phase(run);
  EXPECT_NEAR(run.world().time, 3, 0.01);
  EXPECT_TRUE(run.missed_rest());
}

// Why the first phase does not get to its end; empty where it does.
std::string refusal_of(const Scenario& scene) {
  Protocol run(scene, make_world(scene));
  try {
    EXPECT_EQ(finish_phase(run), Progress::phase_ended);
  } catch (const InputError& error) {
    return error.where() + " " + error.what();
  }
  return {};
}

TEST(Vane, OntoAFixedGrainIsRefusedEvenIfGrainsAreCleared) {
  Scenario scene = bed(Method::automatic, kVane);
  std::get<VanePhase>(scene.phases[0].kind).clear = true;
  for (Disk& disk : scene.disks) disk.fixed = true;
  const std::string refused = refusal_of(scene);
  EXPECT_TRUE(refused.starts_with("phases[0].depth puts the vane onto")) << refused;
}

// Nothing that is immovable stops what is driven at a rate: no contact is computed between the two.
TEST(DriveAtARate, IntoAnImmovableBodyIsRefusedWhereItMeetsIt) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = 20, .height = 10, .sides = Sides::walls, .floor = true};
  scene.step.dt = 0.01;
  scene.disks = {{.position = {18, 5.5}, .fixed = true}};
  const auto penetrating = [&](const IntruderShape& shape, double x, double depth) {
    scene.phases = {{PenetratePhase{.shape = shape, .x = x, .speed = 1, .depth = depth}}};
    return refusal_of(scene);
  };
  const DiskIntruder disk{.diameter = 2};
  const ConeIntruder cone{.width = 2, .length = 1};
  EXPECT_EQ(penetrating(disk, 5, 6), "") << "its way ends on the floor";
  EXPECT_NE(penetrating(disk, 5, 6.5).find("into the floor"), std::string::npos);
  EXPECT_NE(penetrating(cone, 5, 6.5).find("into the floor"), std::string::npos);
  EXPECT_NE(penetrating(disk, 18, 1).find("into body 0"), std::string::npos);
  EXPECT_NE(penetrating(cone, 18.2, 1).find("into body 0"), std::string::npos);
  scene.walls = {{.point = {0, 3}, .normal = {0, 1}}};
  EXPECT_NE(penetrating(cone, 5, 6.5).find("into walls[0]"), std::string::npos);
  scene.walls.clear();
  const auto turning = [&](double x) {
    scene.phases = {{VanePhase{.shape = VaneIntruder{.blades = 3, .radius = 2, .thickness = 0.4},
                               .x = x,
                               .depth = 3,
                               .angular_velocity = 1.0,
                               .angle = 1.5}}};
    return refusal_of(scene);
  };
  EXPECT_EQ(turning(5), "");
  EXPECT_NE(turning(1.5).find("into the left side"), std::string::npos);
}

}  // namespace
}  // namespace quicksand
