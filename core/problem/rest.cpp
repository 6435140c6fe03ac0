#include "core/problem/rest.h"

#include <algorithm>

namespace quicksand {

namespace {

// The momentum of a body that counts as none [m sqrt(g d)].
double least_momentum(const ContactProblem& problem, const SolverSettings& settings) {
  constexpr double kRounding = 1e-13;  // some hundred roundings of an impulse
  const double share = std::max(SolverSettings::kAsItIs * settings.tolerance, kRounding);
  return share * problem.force_scale * problem.dt;
}

bool moves(const Vec3& velocity, const Vec3& inverse_mass, double momentum) {
  constexpr double kArm = 0.5;  // of a grain: what turns moves as fast at its rim [d]
  const Vec3 most = momentum * Vec3(1, 1, kArm).cwiseProduct(inverse_mass);
  return (velocity.array().abs() > most.array()).any();
}

}  // namespace

bool bring_to_rest(const ContactProblem& problem, const SolverSettings& settings,
                   ContactState& state) {
  const double momentum = least_momentum(problem, settings);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    if (state.impulse[c].x() <= 0) continue;
    for (const int body : {problem.contacts[c].a, problem.contacts[c].b}) {
      Vec3& velocity = state.velocity[body];
      if (!moves(velocity, problem.inverse_mass[body], momentum)) velocity.setZero();
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
