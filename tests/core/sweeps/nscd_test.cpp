// Standard nonsmooth contact dynamics: what its sweeps converge to, how fast, and what they leave.
#include "core/sweeps/nscd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "core/checkpoint/checkpoint.h"
#include "core/measures/linear_fit.h"
#include "core/measures/measures.h"
#include "core/problem/residual.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/solvers/contact_solver.h"
#include "core/step/assemble.h"
#include "core/world/neighbors.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"
#include "tests/support/core/tolerance.h"
#include "tests/support/temporary_folder.h"

namespace quicksand {
namespace {

constexpr double kNscdCohesion = 1e4;  // [F_g]

Scenario by_nscd(Scenario scene, int sweeps, SweepOrder order = SweepOrder::random,
                 double dt = 1e-3) {
  scene.step = nscd_step();
  scene.step.nscd = Nscd{.sweeps = sweeps, .order = order};
  scene.step.dt = dt;
  return scene;
}

// The contact problem of a world's first step, from impulses that balance the cohesion.
struct FirstStep {
  explicit FirstStep(const Scenario& scene) : world(make_world(scene)) {
    StepSettings step = nscd_step();
    std::vector<Vec3> free;
    free_velocities(world, step.dt, free);
    std::vector<Contact> contacts;
    find_contacts(world, pairs_within(world, contact_reach(world, free, step.dt)), free, step.dt,
                  contacts);
    build_problem(world, contacts, free, step, problem);
    for (const Contact& c : contacts) state.impulse.push_back(c.impulse);
  }
  // Velocities after so many sweeps (nb).
  std::vector<Vec3> swept(int sweeps, SweepOrder order) const {
    ContactState after = state;
    Random random{7};
    NscdSweeps().solve(problem, {.sweeps = sweeps, .order = order}, {}, after, random);
    return after.velocity;
  }
  std::vector<Vec3> exact() const {
    ContactState solved = state;
    EXPECT_TRUE(solve(problem, {.tolerance = 1e-12}, solved).converged);
    return solved.velocity;
  }
  World world;
  ContactProblem problem;
  ContactState state;
};

double velocity_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double squared = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squared += (a[i] - b[i]).squaredNorm();
  return std::sqrt(squared);
}

// n + 1 bonded disks along x in free space, the first one pulled.
Scenario free_chain(int n) {
  Scenario scene = empty_scene(Method::automatic);
  scene.grain_law = {.cohesion_force = kNscdCohesion};
  for (int i = 0; i <= n; ++i) scene.disks.push_back({.position = {static_cast<double>(i), 0}});
  scene.disk_forces.resize(scene.disks.size(), Vec3(0, 0, 0));
  scene.disk_forces[0] = {-1, 0, 0};
  scene.initial_bonds = InitialBonds::touching;
  return scene;
}

// A disk on two others on the floor, apart enough for all to carry friction.
Scenario three_disk_arch() {
  Scenario scene = column(Method::automatic, 0, paper_law(100));
  scene.disks = {{.position = {-0.6, 0.5}}, {.position = {0.6, 0.5}}, {.position = {0, 1.3}}};
  scene.initial_bonds = InitialBonds::touching;
  return scene;
}

TEST(Nscd, APairIsSolvedByOneSweep) {
  const FirstStep pair(free_chain(1));
  EXPECT_LT(velocity_distance(pair.swept(1, SweepOrder::sorted), pair.exact()),
            tolerance::solved(1e-3));
}

class NscdOrder : public testing::TestWithParam<SweepOrder> {};
INSTANTIATE_TEST_SUITE_P(All, NscdOrder,
                         testing::Values(SweepOrder::random, SweepOrder::sorted,
                                         SweepOrder::alternating));

TEST_P(NscdOrder, ChainAndArchComeToTheExactAnswerAsSweepsGrow) {
  for (const Scenario& scene : {free_chain(10), three_disk_arch()}) {
    const FirstStep step(scene);
    const std::vector<Vec3> exact = step.exact();
    const double few = velocity_distance(step.swept(3, GetParam()), exact);
    EXPECT_LT(velocity_distance(step.swept(30, GetParam()), exact), 0.7 * few);
    EXPECT_LT(velocity_distance(step.swept(3000, GetParam()), exact), 1e-9);
  }
}

// Gauss-Seidel on the second difference of n unknowns reduces the error by cos^2(pi/(n + 1)) a sweep, so a chain
// needs of the order of n^2 sweeps: it relaxes like a diffusion. [Unger 2002]
TEST(Nscd, TheErrorOfAChainFallsByCosineSquaredASweep) {
  for (const int n : {4, 8, 16, 32}) {
    const FirstStep chain(free_chain(n));
    const std::vector<Vec3> exact = chain.exact();
    const int sweeps = n * n;  // until the slowest mode alone is left
    const double before = velocity_distance(chain.swept(sweeps, SweepOrder::sorted), exact);
    const double after = velocity_distance(chain.swept(sweeps + n, SweepOrder::sorted), exact);
    const double cosine = std::cos(std::numbers::pi / (n + 1));
    EXPECT_NEAR(std::pow(after / before, 1.0 / n), cosine * cosine, 1e-3) << n;
  }
}

TEST(Nscd, PackedSweepsAgreeWithTheContactLawOfTheResidual) {
  // Unequal radii couple tangential and rolling impulses.
  const Scenario scene = falling_cluster(Method::automatic, 40, 3, paper_law());
  Simulation run(by_nscd(scene, 20000, SweepOrder::random, 1e-2));
  run.step.break_rule = FailureCriterion::linearised;
  for (int k = 0; k < 100; ++k) {
    run.advance(1);
    ASSERT_LT(run.last.solve.residual.natural, 1e-8) << k;
  }
}

TEST(Nscd, ANewBondExertsNoNetForce) {
  Scenario scene = free_chain(5);
  scene.disk_forces.clear();
  Simulation run(by_nscd(scene, 1));
  run.advance(3);
  for (const Vec3& v : run.world.disks.velocity) EXPECT_EQ(v.norm(), 0);
}

// The straight move opens a bond of a pair that turns by w dt by d (w dt)^2/2, whatever the sweeps.
TEST(Nscd, ATurningPairBreaksWhereTheStraightMoveOpensItsBond) {
  const double dt = 1e-3, threshold = std::sqrt(2 * kRange) / dt;
  for (const double share : {0.98, 1.02}) {
    Simulation run(
        by_nscd(spinning_pair(Method::automatic, share * threshold, kNscdCohesion), 100));
    run.advance(1);
    EXPECT_EQ(run.bonds_broken, share > 1 ? 1 : 0) << share;
  }
}

TEST(Nscd, BondsFailInStepsThatDidNotConverge) {
  // A sweep hands the pull on to the first bond alone.
  Scenario scene = free_chain(20);
  scene.disk_forces[0] = {-1.9e6, 0, 0};
  Simulation run(by_nscd(scene, 1, SweepOrder::sorted));
  run.advance(1);
  EXPECT_FALSE(run.last.converged);
  EXPECT_TRUE(run.last.taken);
  EXPECT_GE(run.bonds_broken, 1);
  EXPECT_EQ(run.breaks_withheld, 0);
  EXPECT_GT(run.last.sweeps.residual, 0);
}

TEST(Nscd, SweepsEndEarlyAtTheirTolerance) {
  Scenario scene = free_chain(5);
  Simulation run(by_nscd(scene, 100000));
  run.step.nscd->tolerance = 1e-9;
  run.advance(1);
  EXPECT_LE(run.last.solve.residual.natural, 1e-9);
  EXPECT_LT(run.last.solve.iterations, 1000);
}

// Two disks that were bonded, apart by more than the range and falling onto each other.
TEST(Nscd, EveryTouchFormsABondAgainWhereThePhaseSaysSo) {
  for (const BondingTouch bonds : {BondingTouch::first, BondingTouch::every}) {
    Scenario scene = free_chain(1);
    scene.disk_forces = {{1, 0, 0}, {-1, 0, 0}};
    scene.disks[1].position.x() += 1e-3;
    scene = by_nscd(scene, 10);
    scene.phases = {
        {SettlePhase{.max_time = 0.2, .until_rest = false, .bonding = true, .bonds = bonds}}};
    World world = make_world(scene);
    world.bonds.form({Pair{0, 1}});
    world.bonds.list[0].state = BondState::broken;
    Protocol protocol(scene, world);
    finish_phase(protocol);
    const Bonds& after = protocol.world().bonds;
    ASSERT_EQ(after.list.size(), 1U);
    EXPECT_EQ(after.list[0].state,
              bonds == BondingTouch::every ? BondState::active : BondState::broken);
    EXPECT_EQ(after.formed, bonds == BondingTouch::every ? 2 : 1);
  }
}

std::uint64_t hash_after(const Scenario& scene, int steps, World* world = nullptr) {
  Protocol protocol(scene, make_world(scene));
  for (int k = 0; k < steps; ++k) protocol.advance();
  if (world) *world = protocol.world();
  return world_hash(protocol.world());
}

TEST(Nscd, TheSameSeedGivesTheSameBytesAndAnotherSeedOthers) {
  const Scenario scene = by_nscd(small_collapse(Method::automatic, 1), 20);
  Scenario other = scene;
  other.seed = 2;
  EXPECT_EQ(hash_after(scene, 300), hash_after(scene, 300));
  EXPECT_NE(hash_after(scene, 300), hash_after(other, 300));
}

// Of small collapses that differ by the order of their sweeps alone.
TEST(Nscd, AnotherStreamOfOrdersGivesOtherBytesAndTheSameStatistics) {
  const Scenario scene =
      by_nscd(small_collapse(Method::automatic, 1), 20, SweepOrder::random, 2e-3);
  std::set<std::uint64_t> hashes;
  const auto shares = [&](std::uint64_t first) {
    std::vector<double> all;
    for (std::uint64_t stream = first; stream < first + 8; ++stream) {
      World world = make_world(scene);
      world.sweep_random = Random{stream};
      Protocol protocol(scene, world);
      while (protocol.advance() != Progress::finished) {
      }
      hashes.insert(world_hash(protocol.world()));
      all.push_back(measure(protocol.world()).remaining_bond_fraction.value_or(0));
    }
    return *mean_of(all);
  };
  const Mean one = shares(1), other = shares(101);
  EXPECT_EQ(hashes.size(), 16U);
  EXPECT_GT(*one.error, 0);
  EXPECT_NEAR(one.value, other.value, 3 * std::hypot(*one.error, *other.error));
}

TEST(Nscd, OrdersGiveOtherBytes) {
  const Scenario scene = by_nscd(small_collapse(Method::automatic, 1), 20);
  const Scenario sorted = by_nscd(small_collapse(Method::automatic, 1), 20, SweepOrder::sorted);
  World random_world, sorted_world;
  EXPECT_NE(hash_after(scene, 300, &random_world), hash_after(sorted, 300, &sorted_world));
  EXPECT_TRUE(random_world.sweep_random);
  EXPECT_FALSE(sorted_world.sweep_random);
}

TEST(Nscd, ACheckpointGoesOnToTheSameBytesInTheMiddleOfARun) {
  const test::TemporaryFolder folder;
  const Scenario scene = by_nscd(small_collapse(Method::automatic, 1), 20);
  Protocol whole(scene, make_world(scene));
  for (int k = 0; k < 150; ++k) whole.advance();
  const auto file = folder.path() / "state.cbor";
  write_checkpoint(file, {whole.world(), whole.state(), ""});
  const Checkpoint read = read_checkpoint(file);
  Protocol rest(scene, read.world, read.protocol);
  for (int k = 0; k < 150; ++k) {
    whole.advance();
    rest.advance();
  }
  EXPECT_EQ(world_hash(rest.world()), world_hash(whole.world()));
  EXPECT_EQ(rest.state().sweep_errors.residual.counts, whole.state().sweep_errors.residual.counts);
  EXPECT_EQ(rest.state().sweep_errors.residual.total(), whole.world().step);
}

TEST(RefusedStepByNscd, LeavesTheWorldAsItWas) {
  Scenario scene = column(Method::automatic, 5, paper_law());
  scene.step.nscd = Nscd{.sweeps = 1, .order = SweepOrder::random};
  scene.step.stop_if_unconverged = true;
  Simulation run(scene);
  const std::uint64_t before = world_hash(run.world);
  run.advance();
  ASSERT_FALSE(run.last.taken) << "one sweep is too few";
  EXPECT_EQ(world_hash(run.world), before);
}

}  // namespace
}  // namespace quicksand
