// M + H^T D H against a dense matrix that is built column by column from the relative velocities.
#include "core/interior_point/contact_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "tests/support/core/random_problems.h"
#include "tests/support/core/tolerance.h"

namespace quicksand {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Eigen::Index at(std::size_t k) { return 3 * static_cast<Eigen::Index>(k); }

// H by columns: what each unit velocity is at each contact.
Matrix dense_jacobian(const ContactProblem& problem) {
  const std::size_t nb = problem.inverse_mass.size(), nc = problem.contacts.size();
  Matrix h = Matrix::Zero(at(nc), at(nb));
  for (std::size_t c = 0; c < nc; ++c) {
    const ContactRow& row = problem.contacts[c];
    for (int k = 0; k < 3; ++k) {
      const Vec3 none(0, 0, 0), unit = Vec3::Unit(k);
      h.block<3, 1>(at(c), 3 * row.a + k) += relative_velocity(row, unit, none);
      h.block<3, 1>(at(c), 3 * row.b + k) += relative_velocity(row, none, unit);
    }
  }
  return h;
}

// (M + H^T D H)^-1 H^T p on the directions that can move.
std::vector<Vec3> dense_velocity_change(const ContactProblem& problem,
                                        const std::vector<Impedance<double>>& impedance,
                                        const std::vector<Vec3>& impulse) {
  const Matrix h = dense_jacobian(problem);
  Matrix d = Matrix::Zero(h.rows(), h.rows());
  Vector p(h.rows());
  for (std::size_t c = 0; c < impulse.size(); ++c) {
    for (int k = 0; k < 3; ++k) d.block<3, 1>(at(c), at(c) + k) = impedance[c] * Vec3::Unit(k);
    p.segment<3>(at(c)) = impulse[c];
  }
  const Matrix all = h.transpose() * d * h;
  const Vector momentum = h.transpose() * p;
  std::vector<Eigen::Index> mobile;
  std::vector<double> mass;
  for (std::size_t i = 0; i < problem.inverse_mass.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (const double inverse = problem.inverse_mass[i][k]; inverse > 0) {
        mobile.push_back(at(i) + k);
        mass.push_back(1 / inverse);
      }
  std::vector<Vec3> dv(problem.inverse_mass.size(), Vec3(0, 0, 0));
  if (mobile.empty()) return dv;
  Matrix reduced = all(mobile, mobile);
  for (std::size_t k = 0; k < mobile.size(); ++k)
    reduced(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)) += mass[k];
  const Vector solution = reduced.fullPivLu().solve(momentum(mobile));
  for (std::size_t k = 0; k < mobile.size(); ++k)
    dv[static_cast<std::size_t>(mobile[k] / 3)][mobile[k] % 3] =
        solution[static_cast<Eigen::Index>(k)];
  return dv;
}

// What linearised contacts answer with: symmetric where they stick; the normal force moves the bound
// of friction where they slide.
std::vector<Impedance<double>> random_impedance(std::size_t nc, double stiffest, Random& random) {
  std::vector<Impedance<double>> impedance(nc);
  for (Impedance<double>& d : impedance) {
    for (double* own : {&d.nn, &d.tt, &d.rr}) *own = std::pow(stiffest, random.uniform());
    d.tn = (random.uniform() - 0.5) * d.nn;
    d.rn = 0.1 * (random.uniform() - 0.5) * d.nn;
  }
  return impedance;
}

// Worst error over the largest velocity.
double error(const ContactProblem& problem, double stiffest, Random& random,
             ContactMatrix& matrix) {
  const std::size_t nc = problem.contacts.size();
  const std::vector<Impedance<double>> impedance = random_impedance(nc, stiffest, random);
  std::vector<Vec3> impulse(nc), found;
  for (Vec3& p : impulse) p = Vec3{random.uniform(), random.uniform(), random.uniform()};
  matrix.attach(problem);
  matrix.factorise(impedance);
  matrix.velocity_change(impulse, found);
  const std::vector<Vec3> expected = dense_velocity_change(problem, impedance, impulse);
  EXPECT_EQ(found.size(), expected.size());
  constexpr double kNone = 1e-30;  // where nothing can move
  double worst = 0, largest = kNone;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    worst = std::max(worst, distance(found[i], expected[i]));
    largest = std::max(largest, expected[i].norm());
  }
  return worst / largest;
}

std::vector<ContactProblem> problems() {
  Random random{1};
  std::vector<ContactProblem> all;
  for (int contacts : {0, 1, 5, 12, 40})
    for (bool fixed : {false, true})
      all.push_back(
          random_problem({.bodies = 12, .contacts = contacts, .fixed_body = fixed}, random));
  // One body against a wall, many times.
  all.push_back(random_problem({.bodies = 2, .contacts = 9}, random));
  // Bodies that move along x only, or turn only, and more that do not move at all.
  for (const Vec3& inverse_mass : {Vec3(1, 0, 0), Vec3(0, 0.01, 0), Vec3(0, 0, 8), Vec3(0, 0, 0)}) {
    all.push_back(random_problem({.bodies = 6, .contacts = 10}, random));
    all.back().inverse_mass[1] = all.back().inverse_mass[4] = inverse_mass;
  }
  // Nothing moves.
  all.push_back(random_problem({.bodies = 3, .contacts = 4}, random));
  for (Vec3& inverse_mass : all.back().inverse_mass) inverse_mass.setZero();
  // Repeated contacts.
  all.push_back(random_problem({.bodies = 5, .contacts = 6}, random));
  for (int k = 0; k < 6; ++k) all.back().contacts.push_back(all.back().contacts[k]);
  return all;
}

TEST(ContactMatrix, IsTheDenseMatrixInAllProblems) {
  Random random{2};
  for (const ContactProblem& problem : problems()) {
    ContactMatrix matrix;
    EXPECT_LE(error(problem, 1, random, matrix), tolerance::rounding())
        << problem.inverse_mass.size() << " bodies, " << problem.contacts.size() << " contacts";
  }
}

TEST(ContactMatrix, StandsImpedanceesFromOneToTenMillion) {
  Random random{3};
  for (const ContactProblem& problem : problems()) {
    ContactMatrix matrix;
    EXPECT_LE(error(problem, 1e7, random, matrix), tolerance::rounding(1e7))
        << problem.inverse_mass.size() << " bodies, " << problem.contacts.size() << " contacts";
  }
}

TEST(ContactMatrix, StandsMassesFromOneToAMillion) {
  Random random{4};
  for (int k = 0; k < 20; ++k) {
    const ContactProblem problem =
        random_problem({.bodies = 8, .contacts = 14, .mass_ratio = 1e6}, random);
    ContactMatrix matrix;
    EXPECT_LE(error(problem, 1e7, random, matrix), tolerance::rounding(1e7));
  }
}

TEST(ContactMatrix, OneObjectServesOneProblemAfterTheOther) {
  Random random{5};
  const std::vector<ContactProblem> all = problems();
  ContactMatrix matrix;
  for (int round = 0; round < 2; ++round)
    for (const ContactProblem& problem : all)
      EXPECT_LE(error(problem, 10, random, matrix), tolerance::rounding(10));
}

TEST(ContactMatrix, AChangeThatIsNoNumberIsNotSmall) {
  Random random{6};
  const ContactProblem problem = random_problem({.bodies = 4, .contacts = 5}, random);
  ContactMatrix matrix;
  matrix.attach(problem);
  matrix.factorise(std::vector<Impedance<double>>(5, {.nn = 1, .tt = 1, .rr = 1}));
  std::vector<Vec3> impulse(5, Vec3(1, 0, 0)), change(4);
  matrix.velocity_change(impulse, change);
  EXPECT_LT(matrix.fastest_change(), 100);
  impulse[2].x() = std::numeric_limits<double>::quiet_NaN();
  matrix.velocity_change(impulse, change);
  EXPECT_EQ(matrix.fastest_change(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace quicksand
