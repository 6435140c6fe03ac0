#include "tests/support/core/random_problems.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace quicksand {

ContactProblem random_problem(const ProblemShape& shape, Random& random) {
  const auto between = [&](double a, double b) { return a + (b - a) * random.uniform(); };
  ContactProblem problem;
  problem.dt = 0.01;
  problem.components = shape.components;
  std::vector<double> radius;
  for (int i = 0; i < shape.bodies; ++i) {
    const double r = between(0.3, 1.2);
    const double m = std::pow(shape.mass_ratio, random.uniform());
    const double inertia = m * r * r / 2;
    const bool fixed = shape.fixed_body && i == 0;
    radius.push_back(r);
    problem.inverse_mass.push_back(fixed ? Vec3(0, 0, 0) : Vec3(1 / m, 1 / m, 1 / inertia));
    problem.free_velocity.push_back(fixed ? Vec3(0, 0, 0)
                                          : Vec3{between(-1, 1), between(-1, 1), between(-1, 1)});
  }
  problem.force_scale = 1 / problem.dt;  // impulses are of order 1
  for (int c = 0; c < shape.contacts; ++c) {
    const int b = 1 + static_cast<int>(random.uniform() * (shape.bodies - 1));
    const int a = static_cast<int>(random.uniform() * b);
    const double angle = between(0, 2 * std::numbers::pi);
    ContactRow row{.a = a, .b = b, .normal = {std::cos(angle), std::sin(angle)}};
    const double radius_a = radius[static_cast<std::size_t>(a)];
    const double radius_b = radius[static_cast<std::size_t>(b)];
    row.spin_a = {0, radius_a};
    row.spin_b = {0, -radius_b};
    row.arm = (radius_a + radius_b) / 2;
    // Never an overlap: those against a fixed body may leave no solution.
    row.offset.x() = random.uniform() < 0.5 ? 0 : between(0, 0.5);
    if (!shape.disks) {
      row.spin_a.x() = between(-1, 1);
      row.spin_b.x() = between(-1, 1);
      row.offset.y() = between(-0.2, 0.2);
      row.offset.z() = between(-0.2, 0.2);
    }
    row.friction = between(0, shape.largest_friction);
    row.rolling = between(0, 0.5);
    row.gap_tolerance = 1e-3;
    problem.contacts.push_back(row);
  }
  return problem;
}

ContactProblem disk_on_floor(const Vec3& free_velocity, double friction, double rolling) {
  ContactProblem problem;
  problem.dt = 0.1;
  problem.force_scale = 1;
  problem.inverse_mass = {Vec3(1, 1, 8), Vec3(0, 0, 0)};
  problem.free_velocity = {free_velocity, Vec3(0, 0, 0)};
  problem.contacts = {{.a = 0,
                       .b = 1,
                       .normal = {0, -1},
                       .spin_a = {0, 0.5},
                       .arm = 0.5,
                       .friction = friction,
                       .rolling = rolling,
                       .gap_tolerance = 1e-3}};
  return problem;
}

ContactState zero_state(const ContactProblem& problem) {
  return {.velocity = problem.free_velocity,
          .impulse = std::vector<Vec3>(problem.contacts.size(), Vec3(0, 0, 0))};
}

namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}

void poison_unused_coefficients(ContactProblem& problem) {
  for (ContactRow& row : problem.contacts) {
    if (problem.components < 3) row.rolling = kNan;
    if (problem.components < 2) row.friction = kNan;
  }
}

void poison_unused_arms(ContactProblem& problem) {
  if (problem.components >= 2) return;
  for (ContactRow& row : problem.contacts) row.arm = row.spin_a.y() = row.spin_b.y() = kNan;
}

}  // namespace quicksand
