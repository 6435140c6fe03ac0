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

// A sum over the edges of stiff springs between bodies, k_e (J_a J_b)^T S (J_a J_b), with a
// non-symmetric S whose symmetric part is positive, like that of contacts that slide.
struct Filled {
  Eigen::MatrixXd dense;
  Eigen::VectorXd rhs;
};

Filled fill(const Graph& graph, double stiffest, Random& random, BlockLu& lu) {
  Filled filled;
  filled.dense.setZero(3 * graph.n, 3 * graph.n);
  filled.rhs.setZero(3 * graph.n);
  for (auto k = 0; k < 3 * graph.n; ++k) filled.rhs[k] = 2 * random.uniform() - 1;
  lu.clear();
  for (int i = 0; i < graph.n; ++i) {
    const Mat3 mass = Vec3(1, 1, 0.1 + random.uniform()).asDiagonal();
    lu.diagonal(i) += mass;
    filled.dense.block<3, 3>(3 * i, 3 * i) += mass;
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [i, j] = graph.edges[e];
    const Mat3 skew = random_block(random);
    const Mat3 law = std::pow(stiffest, random.uniform()) *
                     (Mat3::Identity() + 0.9 * (skew - skew.transpose()) / 2);
    const Mat3 a = random_block(random), b = random_block(random);
    const auto edge = static_cast<int>(e);
    lu.diagonal(i) += a.transpose() * law * a;
    lu.diagonal(j) += b.transpose() * law * b;
    lu.upper(edge) += a.transpose() * law * b;
    lu.lower(edge) += b.transpose() * law * a;
    filled.dense.block<3, 3>(3 * i, 3 * i) += a.transpose() * law * a;
    filled.dense.block<3, 3>(3 * j, 3 * j) += b.transpose() * law * b;
    filled.dense.block<3, 3>(3 * i, 3 * j) += a.transpose() * law * b;
    filled.dense.block<3, 3>(3 * j, 3 * i) += b.transpose() * law * a;
  }
  return filled;
}

// Of the solution against that of Eigen's pivoting LU, relative.
double error(const Filled& filled, BlockLu& lu) {
  std::vector<Vec3> x(static_cast<std::size_t>(filled.rhs.size() / 3));
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = filled.rhs.segment<3>(3 * static_cast<Eigen::Index>(i));
  lu.factorise();
  lu.solve(x);
  if (x.empty()) return 0;
  const Eigen::VectorXd expected = filled.dense.fullPivLu().solve(filled.rhs);
  const Eigen::Map<const Eigen::VectorXd> found(x[0].data(), filled.rhs.size());
  return (found - expected).norm() / expected.norm();
}

TEST(BlockLu, SolvesLikeADenseFactorisationOnAnyGraph) {
  Random random{2};
  for (const Graph& graph : graphs()) {
    BlockLu lu;
    lu.analyse(graph.n, graph.edges);
    EXPECT_LE(error(fill(graph, 1, random, lu), lu), tolerance::rounding()) << graph.name;
  }
}

// Stiff contacts beside soft ones, as an interior point has them at its end; both factorisations lose
// what the condition number takes.
TEST(BlockLu, SolvesStiffnessesFromOneToTenMillion) {
  Random random{3};
  for (const Graph& graph : graphs()) {
    BlockLu lu;
    lu.analyse(graph.n, graph.edges);
    EXPECT_LE(error(fill(graph, 1e7, random, lu), lu), tolerance::rounding(1e7)) << graph.name;
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
        EXPECT_LE(error(fill(graph, 10, random, lu), lu), tolerance::rounding(10)) << graph.name;
      }
    }
}

// Large enough for subtrees; a copy of the matrix, block by block, judges the solution.
TEST(BlockLu, SolvesTheSameBytesOnAnyNumberOfThreads) {
  constexpr int kSide = 50;
  const std::vector<Edge> edges = square_lattice(kSide);
  const auto solution = [&](int threads, bool& negative) {
    std::vector<Vec3> x(kSide * kSide), b;
    with_threads(threads, [&] {
      Random random{6};
      BlockLu lu;
      lu.analyse(kSide * kSide, edges);
      lu.clear();
      for (Vec3& v : x) v = Vec3(random.uniform(), random.uniform(), random.uniform());
      b = x;
      std::vector<Mat3> diagonal(x.size()), upper(edges.size()), lower(edges.size());
      for (std::size_t i = 0; i < x.size(); ++i) {
        diagonal[i] = 5 * Mat3::Identity() + random_block(random);
        lu.diagonal(static_cast<int>(i)) += diagonal[i];
      }
      for (std::size_t e = 0; e < edges.size(); ++e) {
        lu.upper(static_cast<int>(e)) += upper[e] = random_block(random);
        lu.lower(static_cast<int>(e)) += lower[e] = random_block(random);
      }
      lu.factorise();
      lu.solve(x);
      negative = lu.negative();
      for (std::size_t i = 0; i < x.size(); ++i) b[i] -= diagonal[i] * x[i];
      for (std::size_t e = 0; e < edges.size(); ++e) {
        b[static_cast<std::size_t>(edges[e].i)] -=
            upper[e] * x[static_cast<std::size_t>(edges[e].j)];
        b[static_cast<std::size_t>(edges[e].j)] -=
            lower[e] * x[static_cast<std::size_t>(edges[e].i)];
      }
    });
    for (const Vec3& rest : b) EXPECT_LE(rest.norm(), tolerance::rounding(10));
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
              .find("to factorise the contacts of 1500 bodies takes at least 0.4 GB of memory"),
          std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace quicksand
