// The sparse factorisation against a dense one of Eigen.
#include "core/linear/block_lu.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "tests/support/bounded_memory.h"
#include "tests/support/core/graphs.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

struct Graph {
  const char* name;
  int n = 0;
  std::vector<Edge> edges;
};

Graph star(int n) {
  Graph graph{"star", n, {}};
  for (int i = 1; i < n; ++i) graph.edges.push_back(i % 2 ? Edge{0, i} : Edge{i, 0});
  return graph;
}

Graph ring(int n) {
  Graph graph{"ring", n, {}};
  for (int i = 0; i < n; ++i) graph.edges.push_back({i, (i + 1) % n});
  return graph;
}

Graph complete(int n) {
  Graph graph{"complete", n, {}};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < j; ++i) graph.edges.push_back({j, i});
  return graph;
}

// With repeated edges and, usually, several components.
Graph random_graph(int n, int edges, Random& random) {
  Graph graph{"random", n, {}};
  const auto any = [&] { return static_cast<int>(random.uniform() * n); };
  while (static_cast<int>(graph.edges.size()) < edges)
    if (const Edge e{any(), any()}; e.i != e.j) graph.edges.push_back(e);
  return graph;
}

std::vector<Graph> graphs() {
  std::vector<Graph> all{{"nothing", 0, {}},
                         {"one body", 1, {}},
                         {"no edges", 7, {}},
                         {"one edge", 2, {{1, 0}}},
                         {"one edge three times", 2, {{0, 1}, {1, 0}, {0, 1}}},
                         star(12),
                         ring(3),
                         ring(15),
                         complete(8)};
  Random random{1};
  for (int k = 0; k < 40; ++k) {
    const int n = 2 + static_cast<int>(random.uniform() * 30);
    all.push_back(random_graph(n, static_cast<int>(random.uniform() * 3 * n), random));
  }
  return all;
}

Mat3 random_block(Random& random) {
  Mat3 block;
  for (int k = 0; k < 9; ++k) block(k) = 2 * random.uniform() - 1;
  return block;
}

// The blocks of a matrix on a graph.
struct Blocks {
  std::vector<Edge> edges;
  std::vector<Mat3> diagonal, upper, lower;

  explicit Blocks(int n, const std::vector<Edge>& on) : edges(on) {
    diagonal.assign(static_cast<std::size_t>(n), Mat3::Zero());
    upper.assign(edges.size(), Mat3::Zero());
    lower = upper;
  }
  std::vector<Vec3> times(const std::vector<Vec3>& x) const {
    std::vector<Vec3> product(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) product[i] = diagonal[i] * x[i];
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto [i, j] = edges[e];
      product[i] += upper[e] * x[j];
      product[j] += lower[e] * x[i];
    }
    return product;
  }
  Eigen::MatrixXd dense() const {
    const auto n = static_cast<Eigen::Index>(diagonal.size());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (Eigen::Index i = 0; i < n; ++i) all.block<3, 3>(3 * i, 3 * i) = diagonal[i];
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto [i, j] = edges[e];
      all.block<3, 3>(3 * i, 3 * j) += upper[e];
      all.block<3, 3>(3 * j, 3 * i) += lower[e];
    }
    return all;
  }
  // Each part writes its own blocks, and no others.
  void factorise(BlockLu& lu) const {
    lu.factorise([&](int part) {
      const auto position = [&](int i) { return lu.position(i); };
      for (int i = 0; i < static_cast<int>(diagonal.size()); ++i)
        if (lu.part_of(position(i)) == part) lu.diagonal(i).entry() += diagonal[i];
      for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        const auto [i, j] = edges[e];
        if (lu.part_of(std::min(position(i), position(j))) != part) continue;
        lu.upper(e).entry() += upper[e];
        lu.lower(e).entry() += lower[e];
      }
    });
  }
};

std::vector<Vec3> random_vector(std::size_t n, Random& random) {
  std::vector<Vec3> x(n);
  for (Vec3& v : x)
    for (double& component : v) component = 2 * random.uniform() - 1;
  return x;
}

// A sum over the edges of stiff springs between bodies, k_e (J_a J_b)^T S (J_a J_b), with a
// non-symmetric S whose symmetric part is positive, like that of contacts that slide.
Blocks springs(const Graph& graph, double stiffest, Random& random) {
  Blocks blocks(graph.n, graph.edges);
  for (Mat3& mass : blocks.diagonal) mass = Vec3(1, 1, 0.1 + random.uniform()).asDiagonal();
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [i, j] = graph.edges[e];
    const Mat3 skew = random_block(random);
    const Mat3 law = std::pow(stiffest, random.uniform()) *
                     (Mat3::Identity() + 0.9 * (skew - skew.transpose()) / 2);
    const Mat3 a = random_block(random), b = random_block(random);
    blocks.diagonal[i] += a.transpose() * law * a;
    blocks.diagonal[j] += b.transpose() * law * b;
    blocks.upper[e] = a.transpose() * law * b;
    blocks.lower[e] = b.transpose() * law * a;
  }
  return blocks;
}

void solve(const BlockLu& lu, std::vector<Vec3>& x) {
  const auto place = [&](std::size_t i) {
    return static_cast<std::size_t>(lu.position(static_cast<int>(i)));
  };
  std::vector<Eigen::Vector4d> in_order(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) in_order[place(i)] << x[i], 0;
  lu.solve(in_order.data());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = in_order[place(i)].head<3>();
}

// Of a solution against that of Eigen's pivoting LU, relative.
double error(const Blocks& blocks, Random& random, BlockLu& lu) {
  std::vector<Vec3> x = random_vector(blocks.diagonal.size(), random);
  if (x.empty()) return 0;
  const auto size = 3 * static_cast<Eigen::Index>(x.size());
  const Eigen::VectorXd rhs = Eigen::Map<const Eigen::VectorXd>(x[0].data(), size);
  blocks.factorise(lu);
  solve(lu, x);
  const Eigen::VectorXd expected = blocks.dense().fullPivLu().solve(rhs);
  return (Eigen::Map<const Eigen::VectorXd>(x[0].data(), size) - expected).norm() / expected.norm();
}

TEST(BlockLu, SolvesLikeADenseFactorisationOnAnyGraph) {
  Random random{2};
  for (const Graph& graph : graphs()) {
    BlockLu lu;
    lu.analyse(graph.n, graph.edges);
    EXPECT_LE(error(springs(graph, 1, random), random, lu), tolerance::rounding()) << graph.name;
  }
}

// Stiff contacts beside soft ones, as an interior point has them at its end; both factorisations lose
// what the condition number takes.
TEST(BlockLu, SolvesStiffnessesFromOneToTenMillion) {
  Random random{3};
  for (const Graph& graph : graphs()) {
    BlockLu lu;
    lu.analyse(graph.n, graph.edges);
    EXPECT_LE(error(springs(graph, 1e7, random), random, lu), tolerance::rounding(1e7))
        << graph.name;
  }
}

// A solver attaches one object to one problem after the other.
TEST(BlockLu, OneObjectServesOneGraphAfterTheOther) {
  Random random{4};
  BlockLu lu;
  for (int round = 0; round < 2; ++round)
    for (const Graph& graph : graphs()) {
      lu.analyse(graph.n, graph.edges);
      for (int again = 0; again < 2; ++again) {
        EXPECT_LE(error(springs(graph, 10, random), random, lu), tolerance::rounding(10))
            << graph.name;
      }
    }
}

// Large enough for subtrees.
TEST(BlockLu, SolvesTheSameBytesOnAnyNumberOfThreads) {
  constexpr int kSide = 50;
  Random random{6};
  Blocks blocks(kSide * kSide, square_lattice(kSide));
  for (Mat3& block : blocks.diagonal) block = 5 * Mat3::Identity() + random_block(random);
  for (Mat3& block : blocks.upper) block = random_block(random);
  for (Mat3& block : blocks.lower) block = random_block(random);
  const std::vector<Vec3> right = random_vector(blocks.diagonal.size(), random);
  const auto solution = [&](int threads, bool& negative) {
    std::vector<Vec3> x = right;
    with_threads(threads, [&] {
      BlockLu lu;
      lu.analyse(kSide * kSide, blocks.edges);
      EXPECT_GT(lu.parts(), 2);
      for (int again = 0; again < 2; ++again) blocks.factorise(lu);
      solve(lu, x);
      negative = lu.negative();
    });
    const std::vector<Vec3> product = blocks.times(x);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_LE((product[i] - right[i]).norm(), tolerance::rounding(10));
    return x;
  };
  bool negative = false, other = false;
  const std::vector<Vec3> alone = solution(1, negative);
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(solution(threads, other), alone) << threads;
    EXPECT_EQ(other, negative);
  }
}

// Without fill there would be one block an edge; Eigen's ordering counts the diagonal in some degrees
// and not in others, and so eliminates some nodes of degree two before the leaves.
TEST(BlockLu, ATreeHasHardlyAnyFill) {
  Random random{5};
  Graph tree{"tree", 200, {}};
  for (int i = 1; i < tree.n; ++i)
    tree.edges.push_back({i, static_cast<int>(random.uniform() * i)});
  BlockLu lu;
  lu.analyse(tree.n, tree.edges);
  EXPECT_LE(static_cast<double>(lu.fill()), 1.2 * static_cast<double>(tree.edges.size()));
  lu.analyse(50, star(50).edges);
  EXPECT_EQ(lu.fill(), 49U);
  // The last two bodies of a ring are coupled through all others.
  lu.analyse(50, ring(50).edges);
  EXPECT_LE(lu.fill(), 100U);
}

// A tree has no product of two rows of a column: a block product and a subtraction an edge, besides the
// inverses. In a triangle there is one such product, two subtractions.
TEST(BlockLu, OperationsGrowWithTheFill) {
  const auto operations = [](const Graph& graph) {
    BlockLu lu;
    lu.analyse(graph.n, graph.edges);
    return lu.operations();
  };
  EXPECT_EQ(operations({"single", 1, {}}), 90);
  EXPECT_EQ(operations(star(9)), 9 * 90 + 8 * 99);
  EXPECT_EQ(operations(complete(3)), 3 * 90 + 3 * 99 + 108);
}

// 1500 bodies that all touch each other are one supernode: 2.25 million blocks of L, and as many of U.
TEST(BlockLu, RefusesWhatItHasNoMemoryForBeforeItTakesIt) {
  if (!test::kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  const Graph graph = complete(1500);
  BlockLu lu;
  const test::BoundedMemory bound(300'000'000);
  // Once more: the first failure leaves nothing that could be taken for an analysed graph.
  for (int k = 0; k < 2; ++k) {
    try {
      lu.analyse(graph.n, graph.edges);
      FAIL() << "was analysed";
    } catch (const NotEnoughMemory& error) {
      EXPECT_NE(
          std::string(error.what())
              .find("factorising the contacts of 1500 bodies takes at least 0.4 GB of memory"),
          std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace quicksand
