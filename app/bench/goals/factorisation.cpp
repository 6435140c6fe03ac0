// Whether our own factorisation pays: that of M + H^T D H in 3x3 blocks against Eigen's sparse ones, on
// the graph of a standing network. The symbolic part is kept by all. D is random, positive and diagonal,
// so that LDLT can take part; where a contact slides the matrix is not symmetric, which leaves SparseLU.
// Ours fills in the matrix as part of its time, the others have it ready.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <span>

#include "app/bench/goals/goal_cases.h"
#include "app/bench/paper_states.h"
#include "app/bench/step_problem.h"
#include "app/bench/stopwatch.h"
#include "core/base/random.h"
#include "core/interior_point/contact_matrix.h"
#include "core/scene/scenario.h"
#include "core/solvers/contact_solver.h"

namespace quicksand::bench {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

// Rows of bodies that cannot move are those of the unit matrix.
Sparse assembled(const ContactProblem& problem, const std::vector<Impedance<double>>& impedance) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto mobile = [&](int body, int k) { return problem.inverse_mass[body][k] > 0; };
  for (int i = 0; i < static_cast<int>(problem.inverse_mass.size()); ++i)
    for (int k = 0; k < 3; ++k)
      entries.emplace_back(3 * i + k, 3 * i + k, mobile(i, k) ? 1 / problem.inverse_mass[i][k] : 1);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    Eigen::Matrix<double, 3, 6> h;
    for (int k = 0; k < 3; ++k) {
      const Vec3 none(0, 0, 0), unit = Vec3::Unit(k);
      h.col(k) = relative_velocity(row, unit, none);
      h.col(3 + k) = relative_velocity(row, none, unit);
    }
    Eigen::Matrix<double, 3, 6> answer;
    for (int k = 0; k < 6; ++k) answer.col(k) = impedance[c] * h.col(k);
    const Eigen::Matrix<double, 6, 6> block = h.transpose() * answer;
    const auto place = [&](int k) { return 3 * (k < 3 ? row.a : row.b) + k % 3; };
    const auto moves = [&](int k) { return mobile(k < 3 ? row.a : row.b, k % 3); };
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        if (moves(i) && moves(j)) entries.emplace_back(place(i), place(j), block(i, j));
  }
  const auto size = static_cast<Eigen::Index>(3 * problem.inverse_mass.size());
  Sparse matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Per direction of each body; none where it cannot move.
Eigen::VectorXd momentum_of(const ContactProblem& problem, std::span<const Vec3> impulse) {
  const std::size_t bodies = problem.inverse_mass.size();
  Eigen::VectorXd momentum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * bodies));
  for (std::size_t c = 0; c < impulse.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    momentum.segment<3>(3 * row.a) += momentum_of_a(row, impulse[c]);
    momentum.segment<3>(3 * row.b) += momentum_of_b(row, impulse[c]);
  }
  for (std::size_t i = 0; i < bodies; ++i)
    for (int k = 0; k < 3; ++k)
      if (problem.inverse_mass[i][k] == 0) momentum[static_cast<Eigen::Index>(3 * i) + k] = 0;
  return momentum;
}

// The largest difference of a body's velocity.
double difference(const Eigen::VectorXd& velocities, std::span<const Vec3> others) {
  double off = 0;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(3 * i);
    off = std::max(off, (velocities.segment<3>(at) - others[i]).norm());
  }
  return off;
}

}  // namespace

Outcome factorisation(const Options& options) {
  const Scenario scene = paper_scene(options);
  const ContactProblem problem = next_problem(at_rest(options).world, scene.step).problem;
  Random random{1};
  std::vector<Impedance<double>> impedance(problem.contacts.size());
  std::vector<Vec3> impulse;
  for (Impedance<double>& d : impedance) {
    for (double* own : {&d.nn, &d.tt, &d.rr}) *own = std::pow(1e6, random.uniform());
    impulse.push_back(Vec3{random.uniform(), random.uniform(), random.uniform()});
  }
  const Sparse matrix = assembled(problem, impedance);
  const Eigen::VectorXd momentum = momentum_of(problem, impulse);
  ContactMatrix ours;
  ours.attach(problem);
  std::vector<Vec3> change;
  Eigen::SimplicialLDLT<Sparse> ldlt;
  ldlt.analyzePattern(matrix);
  Eigen::SparseLU<Sparse> lu;
  lu.analyzePattern(matrix);

  Outcome outcome;
  Figure block{.what = "block LU", .unit = "ms", .goal = 1};
  Figure over_ldlt{.what = "over Eigen LDLT", .unit = "times", .goal = 2, .more_is_better = true};
  Figure over_lu{.what = "over Eigen LU", .unit = "times", .goal = 2, .more_is_better = true};
  for (int repeat = 0; repeat < options.repeats_or(9); ++repeat) {
    const auto measured = [&](const char* part, auto solve) {
      const Stopwatch watch;
      solve();
      Row run{.what = part, .method = part, .repeat = repeat};
      run.seconds = watch.elapsed();
      run.size = mobile_disks(problem);
      run.contacts = static_cast<std::int64_t>(problem.contacts.size());
      run.factorisations = 1;
      outcome.runs.push_back(run);
      return run.seconds.cpu;
    };
    Eigen::VectorXd by_ldlt, by_lu;
    const double own = measured("block_lu", [&] {
      ours.factorise(impedance);
      ours.velocity_change(impulse, change);
    });
    const double symmetric = measured("eigen_ldlt", [&] {
      ldlt.factorize(matrix);
      by_ldlt = ldlt.solve(momentum);
    });
    const double general = measured("eigen_lu", [&] {
      lu.factorize(matrix);
      by_lu = lu.solve(momentum);
    });
    const double allowed = 1e-6 * by_lu.lpNorm<Eigen::Infinity>();
    block.valid =
        block.valid && difference(by_lu, change) <= allowed && (by_ldlt - by_lu).norm() <= allowed;
    block.values.push_back(1e3 * own);
    over_ldlt.values.push_back(symmetric / own);
    over_lu.values.push_back(general / own);
  }
  outcome.figures = {block, over_ldlt, over_lu};
  if (!block.valid) outcome.notes.emplace_back("the three solutions differ by more than 1e-6");
  return outcome;
}

}  // namespace quicksand::bench
