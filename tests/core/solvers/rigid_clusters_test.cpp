#include "core/solvers/rigid_clusters.h"

#include <gtest/gtest.h>

#include "core/problem/residual.h"
#include "tests/support/core/random_problems.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

// Random bodies of any shape, a random half of their contacts frozen, and clusters that move anyhow.
struct Clustered {
  explicit Clustered(std::uint64_t seed) {
    Random random{seed};
    problem = random_problem(
        {.bodies = 12, .contacts = 16, .components = 3, .mass_ratio = 100, .disks = false}, random);
    const auto between = [&](double a, double b) { return a + (b - a) * random.uniform(); };
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
      frozen.push_back(random.uniform() < 0.5 ? 1 : 0);
      impulse.push_back(Vec3{between(0, 1), between(-1, 1), between(-1, 1)});
    }
    clusters.join(problem, frozen);
    clusters.find_mass_properties(problem, impulse);
    for (int k = 0; k < clusters.size(); ++k)
      of_cluster.push_back(clusters.inverse_mass(k).isZero(0)
                               ? clusters.free_velocity(k)
                               : Vec3{between(-1, 1), between(-1, 1), between(-1, 1)});
    clusters.spread(of_cluster, velocity);
  }
  Vec3 relative(const ContactRow& row) const {
    return row.offset + relative_velocity(row, velocity[row.a], velocity[row.b]);
  }

  ContactProblem problem;
  std::vector<char> frozen;
  std::vector<Vec3> impulse, of_cluster, velocity;
  RigidClusters clusters;
};

class RigidClusterTest : public testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seeds, RigidClusterTest, testing::Range<std::uint64_t>(1, 21));

TEST_P(RigidClusterTest, ContactsOfTheTreeStickHoweverTheClusterMoves) {
  const Clustered s(GetParam());
  int in_tree = 0;
  for (std::size_t c = 0; c < s.frozen.size(); ++c) {
    if (!s.clusters.in_tree(c)) continue;
    ++in_tree;
    EXPECT_TRUE(s.frozen[c]);
    EXPECT_LE(s.relative(s.problem.contacts[c]).norm(), tolerance::rounding(10)) << c;
  }
  EXPECT_EQ(in_tree + s.clusters.size(), 12) << "a tree has one contact less than bodies";
}

TEST_P(RigidClusterTest, FrozenContactsAreInATreeOrInsideAClusterOrHoldTheImmobile) {
  const Clustered s(GetParam());
  for (std::size_t c = 0; c < s.frozen.size(); ++c) {
    if (s.frozen[c]) {
      EXPECT_TRUE(s.clusters.inside(s.problem.contacts[c])) << c;
    }
  }
}

TEST_P(RigidClusterTest, AContactBetweenClustersSeesTheVelocitiesOfItsBodies) {
  const Clustered s(GetParam());
  for (const ContactRow& row : s.problem.contacts) {
    const ContactRow seen = s.clusters.row_between(row);
    const Vec3 u =
        seen.offset + relative_velocity(seen, s.of_cluster[seen.a], s.of_cluster[seen.b]);
    EXPECT_LE(distance(u, s.relative(row)), tolerance::rounding(100));
  }
}

TEST_P(RigidClusterTest, RecoveredImpulsesMoveTheBodiesAsTheirClusters) {
  Clustered s(GetParam());
  // Free clusters move as the contacts between them make them move.
  for (int k = 0; k < s.clusters.size(); ++k) s.of_cluster[k] = s.clusters.free_velocity(k);
  for (std::size_t c = 0; c < s.impulse.size(); ++c) {
    const ContactRow row = s.clusters.row_between(s.problem.contacts[c]);
    if (row.a == row.b) continue;
    s.of_cluster[row.a] +=
        s.clusters.inverse_mass(row.a).cwiseProduct(momentum_of_a(row, s.impulse[c]));
    s.of_cluster[row.b] +=
        s.clusters.inverse_mass(row.b).cwiseProduct(momentum_of_b(row, s.impulse[c]));
  }
  s.clusters.spread(s.of_cluster, s.velocity);
  s.clusters.recover(s.problem, s.velocity, s.impulse);
  std::vector<Vec3> given;
  velocity_from_impulses(s.problem, s.impulse, given);
  for (std::size_t i = 0; i < given.size(); ++i)
    EXPECT_LE(distance(given[i], s.velocity[i]), tolerance::exact()) << i;
}

}  // namespace
}  // namespace quicksand
