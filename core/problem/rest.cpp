#include "core/problem/rest.h"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double kRounding = 1e-13;  // some hundred roundings of an impulse

// The momentum of a body that counts as none [m sqrt(g d)].
double least_momentum(const ContactProblem& problem, const SolverSettings& settings) {
  const double share = std::max(SolverSettings::kAsItIs * settings.tolerance, kRounding);
  return share * problem.force_scale * problem.dt;
}

constexpr double kArm = 0.5;  // of a grain: what turns moves as fast at its rim [d]

double speed(const Vec3& velocity) {
  return velocity.head<2>().norm() + kArm * std::abs(velocity.z());
}

bool moves(const Vec3& velocity, const Vec3& inverse_mass, double momentum) {
  const Vec3 most = momentum * Vec3(1, 1, kArm).cwiseProduct(inverse_mass);
  return (velocity.array().abs() > most.array()).any();
}

}  // namespace

bool bring_to_rest(const ContactProblem& problem, const SolverSettings& settings,
                   const std::vector<Vec3>& by_loads, ContactState& state) {
  // Beside a bond that is strong enough, what a light body gains in a step is within the error of its contacts.
  constexpr double kOfLoads = 1e-6;
  const double momentum = least_momentum(problem, settings);
  const double rounding = kRounding * problem.force_scale * problem.dt;
  const auto rests = [&](int body) {
    const Vec3 &v = state.velocity[body], &inverse_mass = problem.inverse_mass[body];
    return !moves(v, inverse_mass, momentum) &&
           (!moves(v, inverse_mass, rounding) || speed(v) <= kOfLoads * speed(by_loads[body]));
  };
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    if (state.impulse[c].x() <= 0) continue;
    for (const int body : {problem.contacts[c].a, problem.contacts[c].b}) {
      if (rests(body)) state.velocity[body].setZero();
    }
  }
  return std::ranges::all_of(state.velocity, [](const Vec3& v) { return v.isZero(0); });
}

bool taken_as_it_is(const ContactProblem& problem, const SolverSettings& settings,
                    const Residual& residual, const ContactState& state) {
  const double distance = settings.distance(residual);
  if (distance == 0 || distance > SolverSettings::kAsItIs) return distance == 0;
  const double momentum = least_momentum(problem, settings);
  // That of a body that is held or moved from outside is no error.
  const auto errs = [&](int body) {
    const Vec3& inverse_mass = problem.inverse_mass[body];
    return !inverse_mass.isZero(0) && moves(state.velocity[body], inverse_mass, momentum);
  };
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    if (state.impulse[c].x() > 0 && (errs(row.a) || errs(row.b))) return false;
  }
  return true;
}

}  // namespace quicksand
